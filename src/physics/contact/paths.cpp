#include "physics/contact/paths.h"

#include <cmath>

#include "physics/contact/tolerances.h"

namespace carom {

void ContactPaths::begin() {
    pairs_.list_by_body(bodies_);
    paths_.clear();
    place_.resize(bodies_.fixed, none);
}

void ContactPaths::add(std::uint32_t body) {
    if (place_[body] != none) return;
    place_[body] = static_cast<std::uint32_t>(paths_.size());
    const Vec2 before = bodies_.start_velocity[body];
    const ContactBody& after = bodies_.body[body];
    ContactPath& path = paths_.emplace_back();
    path.body = body;
    path.chord.position = bodies_.position[body];
    path.chord.velocity = bodies_.displacement[body] / step_.duration;
    path.surface_speed =
        bodies_.start_surface_speed.empty() ? 0.0 : bodies_.start_surface_speed[body];
    path.turn = (after.surface_speed - path.surface_speed) / step_.duration;
    path.end = step_.duration;
    if (bodies_.is_kinematic(body)) {
        path.velocity = path.chord.velocity;
        return;
    }
    path.velocity = before;
    path.pull = (after.velocity - before) / step_.duration;
    path.is_free = after.velocity ==
                   before * step_.flight.decay + step_.gravity * step_.flight.velocity_per_gravity;
    path.is_on_chord = step_.drag.has_value() || step_.fall > bodies_.radius[body];
}

void ContactPaths::add_around(std::uint32_t body) {
    add(body);
    if ((*this)[body].is_surrounded) return;
    (*this)[body].is_surrounded = true;
    for (const std::uint32_t p : pairs_.of_body(body)) {
        add(pairs_[p].a);
        if (bodies_.is_ball(pairs_[p].b)) add(pairs_[p].b);
    }
}

Vec2 ContactPaths::position_at(std::uint32_t body, double now) const {
    const ContactPath& path = (*this)[body];
    const double since = std::min(now, path.end) - path.chord.time;
    if (!path.is_on_parabola()) return path.chord.position + path.chord.velocity * since;
    return path.chord.position +
           travel(flight_over(step_.drag, since), path.velocity, step_.gravity);
}

Vec2 ContactPaths::velocity_at(std::uint32_t body, double now) const {
    const ContactPath& path = (*this)[body];
    const double since = std::min(now, path.end) - path.chord.time;
    if (!path.is_on_parabola()) return path.velocity + path.pull * since;
    return velocity_after(flight_over(step_.drag, since), path.velocity, step_.gravity);
}

double ContactPaths::surface_speed_at(std::uint32_t body, double now) const {
    const ContactPath& path = (*this)[body];
    return path.surface_speed + path.turn * (std::min(now, path.end) - path.chord.time);
}

// The ball leaves the path on which it began the substep.
void ContactPaths::note_given(ContactPath& path, double now) const {
    if (path.version == 0 && !path.is_free) path.given = std::min(now, path.end) / step_.duration;
}

std::optional<double> ContactPaths::redirect(std::uint32_t body, double now, Vec2 velocity,
                                             double surface_speed) {
    ContactPath& path = (*this)[body];
    note_given(path, now);
    path.chord.position = position_at(body, now);
    path.chord.time = now;
    path.velocity = velocity;
    path.pull = {};
    path.surface_speed = surface_speed;
    path.turn = 0.0;
    path.rolls_on = false;
    ++path.version;
    if (path.is_frozen) return std::nullopt;
    if (++path.impacts >= contact_tolerance::most_impacts) {
        freeze(body, now);
        return std::nullopt;
    }
    if (bodies_.is_kinematic(body)) {
        path.chord.velocity = velocity;
        return std::nullopt;
    }
    const double left = step_.duration - now;
    path.is_free = true;
    path.chord.velocity = carom::chord_velocity(step_.drag, velocity, step_.gravity, left);
    if (path.is_on_chord && left > 0.0)
        path.pull =
            (velocity_after(flight_over(step_.drag, left), velocity, step_.gravity) - velocity) *
            (1.0 / left);
    path.end = step_.duration;
    return end_at_skin(body, now);
}

std::optional<double> ContactPaths::roll_on(std::uint32_t body, double now, Vec2 velocity,
                                            double surface_speed, Vec2 normal) {
    const double press = -dot(step_.gravity, normal);
    ContactPath& path = (*this)[body];
    const bool was_free = path.is_free;
    if (path.is_frozen || (was_free && !(press > 0.0)))
        return redirect(body, now, velocity, surface_speed);
    path.chord.position = position_at(body, now);
    path.chord.time = now;
    path.velocity = velocity;
    path.pull = was_free ? step_.gravity + normal * press : Vec2{};
    path.chord.velocity = velocity + path.pull * (0.5 * (step_.duration - now));
    path.surface_speed = surface_speed;
    path.turn = 0.0;
    path.end = step_.duration;
    path.is_free = false;
    path.rolls_on = true;
    ++path.version;
    if (++path.impacts >= contact_tolerance::most_impacts) {
        freeze(body, now);
        return std::nullopt;
    }
    return end_at_skin(body, now);
}

std::optional<double> ContactPaths::end_at_skin(std::uint32_t body, double now) {
    ContactPath& path = (*this)[body];
    const Vec2 away = path.chord.position - bodies_.reference[body];
    const double room = bodies_.skin[body] * bodies_.skin[body];
    const double left = step_.duration - now;
    if (length_squared(away + path.chord.velocity * left) <= room) return std::nullopt;
    // |away + chord t|^2 = room
    const double a = length_squared(path.chord.velocity);
    const double b = dot(away, path.chord.velocity);
    const double c = std::min(0.0, length_squared(away) - room);
    const double root = std::sqrt(std::max(0.0, b * b - a * c));
    double time = 0.0;
    if (b > 0.0)
        time = -c / (b + root);
    else if (a > 0.0)
        time = (root - b) / a;
    path.end = std::clamp(now + time, now, step_.duration);
    return path.end;
}

void ContactPaths::count_push(std::uint32_t body, double now) {
    ContactPath& path = (*this)[body];
    if (++path.pushes < contact_tolerance::most_pushes) return;
    if (!path.is_frozen) freeze(body, now);
    path.velocity = {};
}

void ContactPaths::freeze(std::uint32_t body, double now) {
    ContactPath& path = (*this)[body];
    note_given(path, now);
    const double since = std::min(now, path.end) - path.chord.time;
    const Vec2 velocity = velocity_at(body, now);
    path.chord.position = position_at(body, now);
    path.velocity = velocity;
    path.surface_speed += path.turn * since;
    path.chord.velocity = path.pull = {};
    path.turn = 0.0;
    path.chord.time = now;
    path.end = step_.duration;
    path.is_free = false;
    path.is_frozen = true;
    ++path.version;
    standing_.push_back(bodies_.ball[body]);
}

void ContactPaths::freeze_pushed(std::uint32_t other, std::uint32_t body, Vec2 normal, double now) {
    if ((*this)[other].is_frozen) freeze_at(body, normal, now);
}

void ContactPaths::freeze_at(std::uint32_t body, Vec2 normal, double now) {
    if ((*this)[body].is_frozen || bodies_.is_kinematic(body)) return;
    if (dot((*this)[body].chord.velocity, normal) < 0.0) freeze(body, now);
}

// Friction may take back only what both balls have felt: else it would speed up slip. A frozen ball
// has not felt what pushed the other one away from it: where the two separate faster than resting
// contact does, that impulse would push again in the next substep. Where they do not, it is a load
// that one of them still carries.
void ContactPaths::reverse_undelivered_impulses() const {
    for (const ContactPath& path : paths_) {
        if (!keeps_impulses(path.body)) continue;
        for (const std::uint32_t p : pairs_.of_body(path.body)) {
            ContactPair& pair = pairs_[p];
            if (pair.state != ContactState::constraint || pair.is_hinged) continue;
            if (path.body == pair.a || !keeps_impulses(pair.a)) reverse_undelivered_impulse(pair);
        }
    }
}

// Whether constraints may keep impulses that this ball has not felt.
bool ContactPaths::keeps_impulses(std::uint32_t body) const {
    return has_path(body) && ((*this)[body].given < 1.0 || (*this)[body].rolls_on);
}

void ContactPaths::reverse_undelivered_impulse(ContactPair& constraint) const {
    if (constraint.b == bodies_.fixed && has_path(constraint.a) && (*this)[constraint.a].rolls_on) {
        // It has left this piece of the curve with all of the impulse, and meets it no more.
        constraint.normal = {};
        constraint.impulse = constraint.tangential_impulse = 0.0;
        return;
    }
    struct Share {
        double friction = 1.0;
        double impulse = 1.0;
    };
    const auto given = [&](std::uint32_t body) -> Share {
        if (!has_path(body)) return {};
        const ContactPath& path = (*this)[body];
        return {.friction = path.given, .impulse = path.is_frozen ? path.given : 1.0};
    };
    const auto velocity_then = [&](std::uint32_t body) {
        return has_path(body) ? velocity_at(body, step_.duration) : bodies_.body[body].velocity;
    };
    const Share a = given(constraint.a);
    const Share b = given(constraint.b);
    const double share = std::min(a.impulse, b.impulse);
    if (share < 1.0) {
        const Vec2 relative = velocity_then(constraint.a) - velocity_then(constraint.b);
        if (dot(relative, constraint.normal) > contact_tolerance::most_excess * step_.rest_speed)
            constraint.impulse *= share;
    }
    constraint.tangential_impulse *= std::min(a.friction, b.friction);
}

void ContactPaths::finish(const World& world) {
    reverse_undelivered_impulses();
    for (std::uint32_t i = 0; i < bodies_.fixed; ++i)
        if (!has_path(i) || (*this)[i].version == 0) bodies_.position[i] += bodies_.displacement[i];
    for (const ContactPath& path : paths_) {
        const std::uint32_t i = path.body;
        ContactBody& body = bodies_.body[i];
        if (path.version > 0) {
            const Vec2 after = position_at(i, step_.duration);
            bodies_.displacement[i] = after - bodies_.position[i];
            bodies_.position[i] = after;
            body.velocity = velocity_at(i, step_.duration);
            body.surface_speed = surface_speed_at(i, step_.duration);
        }
        if (bodies_.is_kinematic(i)) body.velocity = path.chord.velocity;
        place_[i] = none;
    }
    if (!world.model().speed_limit) return;
    for (std::uint32_t i = 0; i < bodies_.fixed; ++i)
        bodies_.body[i].velocity = limited(bodies_.body[i].velocity, *world.model().speed_limit);
}

}  // namespace carom
