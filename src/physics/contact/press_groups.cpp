#include "physics/contact/press_groups.h"

#include <algorithm>
#include <numeric>

#include "physics/contact/tolerances.h"

namespace carom {

namespace {

// Twice the kinetic energy for each unit of mass.
double squares_of(const ContactSubstep& step, Vec2 velocity, double surface_speed) {
    return length_squared(velocity) + surface_speed * surface_speed * step.spin_share;
}

// The energy at the start of the substep; the potential energy is 0 where the ball is now.
double energy_before(const ContactSubstep& step, const ContactBodies& bodies, std::uint32_t ball) {
    const double surface_speed = step.spins ? bodies.start_surface_speed[ball] : 0.0;
    const double kinetic = 0.5 * squares_of(step, bodies.start_velocity[ball], surface_speed);
    return (kinetic + dot(step.gravity, bodies.displacement[ball])) /
           bodies.body[ball].inverse_mass;
}

// Constraints move balls before they are relaxed: one that has given its impulse back has still
// moved its bodies.
bool has_pressed(const ContactPair& pair) {
    return pair.has_pressed || pair.impulse > 0.0;
}

}  // namespace

double kinetic_energy_of(const ContactSubstep& step, const ContactBodies& bodies,
                         std::uint32_t ball) {
    const ContactBody& body = bodies.body[ball];
    return 0.5 * squares_of(step, body.velocity, body.surface_speed) / body.inverse_mass;
}

double gain_of(const ContactSubstep& step, const ContactBodies& bodies, std::uint32_t ball) {
    return kinetic_energy_of(step, bodies, ball) - energy_before(step, bodies, ball);
}

void PressGroup::join(const PressGroup& other) {
    gain += other.gain;
    lift += other.lift;
    kinetic += other.kinetic;
    mass += other.mass;
    momentum += other.momentum;
    is_supported = is_supported || other.is_supported;
    stays = stays || other.stays;
    is_embedded = is_embedded || other.is_embedded;
}

void PressGroups::find(std::span<const std::uint32_t> constraints) {
    if (found_.empty()) {
        join_balls(constraints);
        number_groups();
        mark();
        mark_hinged();
    }
    groups_ = found_;
    sum_up();
}

// The first ball of the group, as far as it is known.
std::uint32_t PressGroups::first_of(std::uint32_t ball) {
    while (earlier_[ball] != ball)
        ball = earlier_[ball] = earlier_[earlier_[ball]];
    return ball;
}

void PressGroups::join_balls(std::span<const std::uint32_t> constraints) {
    earlier_.resize(bodies_.fixed);
    std::iota(earlier_.begin(), earlier_.end(), 0U);
    state_.resize(bodies_.fixed);
    for (std::uint32_t i = 0; i < bodies_.fixed; ++i)
        state_[i] = bodies_.is_kinematic(i) ? State::kinematic : State::free;
    others_.clear();
    // Embedded balls are further in one another than this, at least.
    const double embedded = -contact_tolerance::embedded * contact_tolerance::overlap_limit *
                            bodies_.smallest_radius * step_.softness.push;
    for (const std::uint32_t p : constraints) {
        const ContactPair& constraint = pairs_[p];
        const bool is_free = is_free_ball(constraint.a) && is_free_ball(constraint.b);
        if (!is_free || constraint.target < embedded) others_.push_back(p);
        // Also what overlaps and does not press.
        const bool presses = has_pressed(constraint);
        if (!is_free || !(presses || constraint.target <= 0.0)) continue;
        if (presses) state_[constraint.a] = state_[constraint.b] = State::pressed_by_ball;
        std::uint32_t& a = earlier_[constraint.a];
        std::uint32_t& b = earlier_[constraint.b];
        if (a == b) continue;
        const std::uint32_t first = std::min(first_of(a), first_of(b));
        earlier_[first_of(a)] = earlier_[first_of(b)] = first;
        a = b = first;
    }
}

void PressGroups::number_groups() {
    found_.clear();
    group_.resize(bodies_.fixed);
    for (std::uint32_t i = 0; i < bodies_.fixed; ++i) {
        if (earlier_[i] < i) {
            group_[i] = group_[earlier_[i]];
        } else {
            group_[i] = static_cast<std::uint32_t>(found_.size());
            found_.push_back({.joined = group_[i]});
        }
        if (state_[i] == State::pressed_by_ball) found_[group_[i]].is_pressed = true;
    }
}

// What constraints other than those of two free balls say of a group, and embedded balls.
void PressGroups::mark() {
    for (const std::uint32_t p : others_) {
        const ContactPair& pair = pairs_[p];
        const bool is_a = is_free_ball(pair.a);
        if (is_a && is_embedded(bodies_, pair)) found_[group_[pair.a]].is_embedded = true;
        if (!has_pressed(pair) || is_a == is_free_ball(pair.b)) continue;
        PressGroup& group = found_[group_[is_a ? pair.a : pair.b]];
        group.is_pressed = group.is_supported = true;
        group.stays = group.stays || pair.is_kinematic;
    }
}

void PressGroups::mark_hinged() {
    for (const std::uint32_t p : pairs_.kinematic()) {
        const ContactPair& pair = pairs_[p];
        if (!pair.is_hinged || pair.state != ContactState::constraint || !(pair.impulse > 0.0))
            continue;
        PressGroup& group = found_[group_[pair.a]];
        group.is_supported = group.stays = true;
    }
}

void PressGroups::sum_up() {
    for (std::uint32_t i = 0; i < bodies_.fixed; ++i) {
        if (bodies_.is_kinematic(i)) continue;
        PressGroup& group = groups_[group_[i]];
        const double mass = 1.0 / bodies_.body[i].inverse_mass;
        group.lift -= mass * dot(step_.gravity, bodies_.displacement[i]);
        // What impacts alone have given is not for the constraints to pay.
        const double kinetic = kinetic_energy_of(step_, bodies_, i);
        if (group.is_pressed) group.gain += kinetic - energy_before(step_, bodies_, i);
        group.kinetic += kinetic;
        group.mass += mass;
        group.momentum += bodies_.body[i].velocity * mass;
    }
}

std::uint32_t PressGroups::largest() const {
    const auto heavier = [](const PressGroup& a, const PressGroup& b) { return a.mass < b.mass; };
    return static_cast<std::uint32_t>(std::ranges::max_element(groups_, heavier) - groups_.begin());
}

// A faster ball has not been pressed or fallen into the room that it has, but flown.
bool PressGroups::is_slow(std::uint32_t ball) const {
    const double most = contact_tolerance::most_excess * step_.rest_speed;
    return length_squared(bodies_.body[ball].velocity) <= most * most;
}

bool PressGroups::have_room(const ContactPair& pair) const {
    if (!bodies_.is_ball(pair.b) || bodies_.is_kinematic(pair.a) || bodies_.is_kinematic(pair.b))
        return true;
    const PressGroup& a = of(pair.a);
    const PressGroup& b = of(pair.b);
    if (&a == &b) return true;
    const Vec2 change = (b.goes_back() ? bodies_.displacement[pair.b] : Vec2{}) -
                        (a.goes_back() ? bodies_.displacement[pair.a] : Vec2{});
    if (change == Vec2{}) return true;
    Vec2 offset = bodies_.position[pair.a] - bodies_.position[pair.b];
    if (step_.wraps) offset = nearest_image(offset, step_.torus);
    const double then = length(offset + change);
    return then >= bodies_.radius[pair.a] + bodies_.radius[pair.b] || then >= length(offset);
}

void PressGroups::join_followers() {
    if (groups_.size() < 2) return;
    // A pair of two groups has a ball outside the largest one, so that one need not be searched.
    const std::uint32_t most = largest();
    pairs_.list_by_body(bodies_);
    for (bool has_changed = true; has_changed;) {
        has_changed = false;
        for (std::uint32_t i = 0; i < bodies_.fixed; ++i) {
            if (group_[i] == most || bodies_.is_kinematic(i)) continue;
            for (const std::uint32_t p : pairs_.of_body(i)) {
                const ContactPair& pair = pairs_[p];
                if (have_room(pair)) continue;
                PressGroup& a = groups_[index_of(pair.a)];
                PressGroup& b = groups_[index_of(pair.b)];
                has_changed = true;
                if (is_slow(pair.a) && is_slow(pair.b)) {
                    b.join(a);
                    a.joined = b.joined;
                } else {
                    a.stays = b.stays = true;
                }
            }
        }
    }
}

double PressGroups::gains() const {
    double gains = 0.0;
    for (std::uint32_t g = 0; g < groups_.size(); ++g)
        if (groups_[g].joined == g) gains += std::max(0.0, groups_[g].gain);
    return gains;
}

}  // namespace carom
