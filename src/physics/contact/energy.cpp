#include "physics/contact/energy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/contact/tolerances.h"

namespace carom {
namespace {

// Also what overlaps and no longer presses: it may have pressed before the last iteration.
bool touches(const ContactConstraint& constraint) {
    return constraint.impulse > 0.0 || constraint.target <= 0.0;
}

}  // namespace

// Twice the kinetic energy for each unit of mass.
double ContactEnergy::squares_of(Vec2 velocity, double surface_speed) const {
    return length_squared(velocity) + surface_speed * surface_speed * (1.0 / step_.spin_ease);
}

double ContactEnergy::kinetic_energy_of(std::uint32_t i) const {
    const ContactBody& body = bodies_.body[i];
    return 0.5 * squares_of(body.velocity, body.surface_speed) / body.inverse_mass;
}

// What the ball has gained in the substep.
double ContactEnergy::gain_of(std::uint32_t i) const {
    const double surface_speed = step_.spins ? bodies_.start_surface_speed[i] : 0.0;
    const double before = 0.5 * squares_of(bodies_.start_velocity[i], surface_speed);
    return kinetic_energy_of(i) -
           (before + dot(step_.gravity, bodies_.displacement[i])) / bodies_.body[i].inverse_mass;
}

void ContactEnergy::end_substep(std::span<const ContactConstraint> constraints,
                                std::span<const BodyPair> impacts, double given) {
    if (constraints.empty()) return;
    if (!energy_) energy_ = energy_of_balls();
    const double gain = (step_.spins ? gain_of_balls<true>() : gain_of_balls<false>()) - given;
    stored_ = std::min(stored_ - gain, contact_tolerance::most_stored * *energy_);
    if (!(gain > 0.0) || !(excess() > 0.0)) return;
    find_groups(constraints);
    find_staying();
    stored_ += take_back(excess());
    if (excess() > 0.0) stored_ += take_from_hit(impacts, excess());
}

// Potential energy is 0 at the lowest point of the lowest ball.
double ContactEnergy::energy_of_balls() const {
    const double weight = length(step_.gravity);
    double energy = 0.0;
    double mass = 0.0;
    double lowest = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < bodies_.fixed; ++i) {
        if (bodies_.is_kinematic(i)) continue;
        const double m = 1.0 / bodies_.body[i].inverse_mass;
        const double height = -dot(step_.gravity, bodies_.position[i]);
        energy += kinetic_energy_of(i) + m * height;
        mass += m;
        lowest = std::min(lowest, height - weight * bodies_.radius[i]);
    }
    return mass > 0.0 ? std::max(0.0, energy - mass * lowest) : 0.0;
}

// What all balls have gained in the substep. This runs in every substep.
template <bool spin>
double ContactEnergy::gain_of_balls() const {
    const double ease = 1.0 / step_.spin_ease;
    double gain = 0.0;
    for (std::uint32_t i = 0; i < bodies_.fixed; ++i) {
        const ContactBody& body = bodies_.body[i];
        if (body.inverse_mass == 0.0) continue;
        double squares = length_squared(body.velocity) - length_squared(bodies_.start_velocity[i]);
        if constexpr (spin) {
            const double before = bodies_.start_surface_speed[i];
            squares += (body.surface_speed * body.surface_speed - before * before) * ease;
        }
        gain += (0.5 * squares - dot(step_.gravity, bodies_.displacement[i])) / body.inverse_mass;
    }
    return gain;
}

std::uint32_t ContactEnergy::root_of(std::uint32_t body) {
    while (parent_[body] != body)
        body = parent_[body] = parent_[parent_[body]];
    return body;
}

void ContactEnergy::find_groups(std::span<const ContactConstraint> constraints) {
    parent_.resize(bodies_.fixed);
    groups_.assign(bodies_.fixed, {});
    for (std::uint32_t i = 0; i < bodies_.fixed; ++i)
        parent_[i] = i;
    for (const ContactConstraint& constraint : constraints)
        if (touches(constraint) && !bodies_.is_kinematic(constraint.a) &&
            !bodies_.is_kinematic(constraint.b))
            parent_[root_of(constraint.a)] = root_of(constraint.b);
    for (std::uint32_t i = 0; i < bodies_.fixed; ++i)
        parent_[i] = root_of(i);
    for (const ContactConstraint& constraint : constraints) {
        const ContactPair& pair = pairs_[constraint.pair];
        if (is_embedded(bodies_, pair)) groups_[parent_[constraint.a]].is_embedded = true;
        if (!(constraint.impulse > 0.0)) continue;
        const bool by_a = bodies_.is_kinematic(constraint.a);
        const bool by_b = bodies_.is_kinematic(constraint.b);
        if (!by_a) groups_[parent_[constraint.a]].is_pressed = true;
        if (!by_b) groups_[parent_[constraint.b]].is_pressed = true;
        if (by_a == by_b) continue;
        Group& group = groups_[parent_[by_a ? constraint.b : constraint.a]];
        group.is_supported = true;
        group.stays = group.stays || pair.is_kinematic;
    }
    for (const std::uint32_t p : pairs_.kinematic()) {
        const ContactPair& pair = pairs_[p];
        if (!pair.is_hinged || pair.state != ContactState::constraint || !(pair.impulse > 0.0))
            continue;
        Group& group = groups_[parent_[pair.a]];
        group.is_supported = group.stays = true;
    }
    for (std::uint32_t i = 0; i < bodies_.fixed; ++i) {
        if (bodies_.is_kinematic(i)) continue;
        Group& group = groups_[parent_[i]];
        const double mass = 1.0 / bodies_.body[i].inverse_mass;
        // What impacts alone have given is not for the constraints to pay.
        if (group.is_pressed) group.gain += gain_of(i);
        group.lift -= mass * dot(step_.gravity, bodies_.displacement[i]);
        group.kinetic += kinetic_energy_of(i);
        group.mass += mass;
        group.momentum += bodies_.body[i].velocity * mass;
    }
}

// Whether these groups may go back by their displacements without a ball entering one that has
// followed it into the room that it left, deeper than it is in there.
bool ContactEnergy::have_room(const ContactPair& pair) {
    const auto way_back = [&](std::uint32_t body) {
        const Group& group = groups_[parent_[body]];
        const bool goes = group.gain > 0.0 && group.lift > 0.0 && group.may_go_back();
        return goes ? bodies_.displacement[body] : Vec2{};
    };
    if (!bodies_.is_ball(pair.b) || bodies_.is_kinematic(pair.a) || bodies_.is_kinematic(pair.b))
        return true;
    if (parent_[pair.a] == parent_[pair.b]) return true;
    const Vec2 change = way_back(pair.b) - way_back(pair.a);
    if (change == Vec2{}) return true;
    Vec2 offset = bodies_.position[pair.a] - bodies_.position[pair.b];
    if (step_.wraps) offset = nearest_image(offset, step_.torus);
    const double then = length(offset + change);
    return then >= bodies_.radius[pair.a] + bodies_.radius[pair.b] || then >= length(offset);
}

// A group that stays may be in the way of another one: until no group changes.
void ContactEnergy::find_staying() {
    for (bool has_changed = true; has_changed;) {
        has_changed = false;
        for (std::uint32_t p = 0; p < pairs_.size(); ++p) {
            const ContactPair& pair = pairs_[p];
            if (have_room(pair)) continue;
            groups_[parent_[pair.a]].stays = groups_[parent_[pair.b]].stays = true;
            has_changed = true;
        }
    }
}

// Takes energy from all groups that have gained, in proportion. Returns how much.
double ContactEnergy::take_back(double excess) {
    double gains = 0.0;
    for (std::uint32_t i = 0; i < bodies_.fixed; ++i)
        if (parent_[i] == i) gains += std::max(0.0, groups_[i].gain);
    if (!(gains > 0.0)) return 0.0;
    double taken = 0.0;
    for (std::uint32_t i = 0; i < bodies_.fixed; ++i) {
        if (bodies_.is_kinematic(i)) continue;
        const Group& group = groups_[parent_[i]];
        if (group.gain > 0.0) taken += take_back(i, group, std::min(1.0, excess / gains));
    }
    return taken;
}

// Takes energy from the balls that pressed groups have hit, of what they have gained, in
// proportion. Returns how much.
double ContactEnergy::take_from_hit(std::span<const BodyPair> impacts, double excess) {
    hit_.clear();
    for (const auto& [a, b] : impacts) {
        if (parent_[a] == parent_[b]) continue;
        if (groups_[parent_[b]].is_pressed && !groups_[parent_[a]].is_pressed) hit_.push_back(a);
        if (groups_[parent_[a]].is_pressed && !groups_[parent_[b]].is_pressed) hit_.push_back(b);
    }
    std::ranges::sort(hit_);
    hit_.erase(std::unique(hit_.begin(), hit_.end()), hit_.end());
    double gains = 0.0;
    for (const std::uint32_t i : hit_)
        gains += std::max(0.0, gain_of(i));
    if (!(gains > 0.0)) return 0.0;
    double taken = 0.0;
    for (const std::uint32_t i : hit_) {
        const double kinetic = kinetic_energy_of(i);
        const double part = std::min(1.0, excess / gains) * std::max(0.0, gain_of(i));
        const double kept = std::sqrt(std::max(0.0, 1.0 - part / kinetic));
        if (!(part > 0.0)) continue;
        bodies_.body[i].velocity *= kept;
        bodies_.body[i].surface_speed *= kept;
        taken += kinetic - kinetic_energy_of(i);
    }
    return taken;
}

// Takes this share of the group's gain from the ball: from its height and its speed, whichever have
// gained. A ball that is moved back is slowed too. A group that nothing supports keeps its way and
// its momentum, unless its balls hardly move relative to each other: its centre of mass flies, and
// constraints cannot lift it.
double ContactEnergy::take_back(std::uint32_t i, const Group& group, double share) {
    ContactBody& body = bodies_.body[i];
    const double lifted = group.may_go_back() ? std::max(0.0, group.lift) : 0.0;
    const double sped = group.is_supported ? std::max(0.0, group.gain - group.lift) : group.gain;
    const double part = std::min(1.0, share * group.gain / (lifted + sped));
    if (!(part > 0.0)) return 0.0;
    Vec2 centre = group.is_supported ? Vec2{} : group.momentum / group.mass;
    double inner = group.kinetic - 0.5 * group.mass * length_squared(centre);
    double kept = lifted > 0.0 ? 1.0 - part : 1.0;
    if (part * sped > inner) {
        centre = {};
        inner = group.kinetic;
        kept = 1.0;
    }
    if (inner > 0.0) kept *= std::sqrt(std::max(0.0, 1.0 - part * sped / inner));
    const double before = kinetic_energy_of(i);
    body.velocity = centre + (body.velocity - centre) * kept;
    body.surface_speed *= kept;
    double taken = before - kinetic_energy_of(i);
    if (lifted > 0.0) {
        Vec2 back = bodies_.displacement[i] * part;
        if (group.is_embedded)
            back = step_.gravity * (dot(back, step_.gravity) / length_squared(step_.gravity));
        bodies_.position[i] -= back;
        bodies_.displacement[i] -= back;
        taken -= dot(step_.gravity, back) / body.inverse_mass;
    }
    return taken;
}

}  // namespace carom
