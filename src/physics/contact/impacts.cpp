#include "physics/contact/impacts.h"

#include <algorithm>
#include <cmath>

#include "physics/ccd/time_of_impact.h"
#include "physics/contact/tolerances.h"
#include "physics/laws/bounce.h"

namespace carom {

namespace {

// Whether gravity moves the ball in a substep by more than what constraints correct easily.
bool has_far_fall(const ContactSubstep& step, const ContactBodies& bodies, std::uint32_t ball) {
    return step.fall > contact_tolerance::far_fall * bodies.radius[ball];
}

}  // namespace

// A ball that no impulse has changed flies on its exact path. One that an impulse presses goes
// straight on at its new velocity, which is g h^2 / 2 lower; else constraints would not hold it.
// Where that is much, what lies between has a share of both, so that a small impulse moves a ball
// by little, and never against itself.
void ContactImpacts::find_displacements() {
    const Flight flight = step_.flight;
    const Vec2 fall = step_.gravity * flight.velocity_per_gravity;
    const Vec2 drop = step_.gravity * flight.travel_per_gravity;
    const double full = contact_tolerance::full_press * length(fall);
    escaped_.clear();
    pushed_.clear();
    double most = 0.0;
    // A pair in which no ball is moved further than `far` off its free flight cannot meet because
    // of that. Without drag, all balls that are pressed are `lag` behind it at least.
    const double far = 0.5 * closing_gap(bodies_);
    const Vec2 lag = fall * step_.duration - drop;
    const double near = step_.drag ? 0.0 : std::max(0.0, far - length(lag)) / step_.duration;
    const bool any_far_fall = step_.fall > contact_tolerance::far_fall * bodies_.smallest_radius;
    // In locals, which a compiler need not read again after each list that grows.
    const double duration = step_.duration;
    const std::span<const ContactBody> body(bodies_.body);
    const std::span<const Vec2> start_velocity(bodies_.start_velocity);
    const std::span<const Vec2> position(bodies_.position);
    const std::span<const Vec2> reference(bodies_.reference);
    const std::span<const double> skin(bodies_.skin);
    const std::span<Vec2> displacements(bodies_.displacement);
    const std::uint32_t count = bodies_.fixed;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec2 velocity = body[i].velocity;
        const Vec2 before = start_velocity[i];
        const Vec2 change = velocity - (before * flight.decay + fall);
        Vec2 displacement;
        if (change == Vec2{}) {
            displacement = before * flight.travel_per_velocity + drop;
        } else {
            displacement = velocity * duration;
            const double press = length_squared(change);
            most = std::max(most, press);
            const auto flown = [&] { return before * flight.travel_per_velocity + drop; };
            if (any_far_fall && press < full * full && has_far_fall(step_, bodies_, i)) {
                const Vec2 pushed = flown() + change * duration;
                displacement = pushed + (displacement - pushed) * (std::sqrt(press) / full);
            }
            if (press > near * near && length_squared(displacement - flown()) > far * far)
                pushed_.push_back(i);
        }
        displacements[i] = displacement;
        const Vec2 away = position[i] + displacement - reference[i];
        if (length_squared(away) > skin[i] * skin[i]) escaped_.push_back(i);
    }
    kinematics_.set_displacements(bodies_, step_);
    most_push_ = std::sqrt(most) * step_.duration;
}

// Distance under uniform motion is convex in time, so the approach along the initial normal bounds
// how far the gap can shrink.
void ContactImpacts::find_candidates() {
    candidates_.clear();
    const auto shrinks = [&](const ContactPair& pair) {
        if (pair.b <= bodies_.fixed)
            return -dot(bodies_.displacement[pair.a] - bodies_.displacement[pair.b], pair.normal);
        const HeldEdge& edge = kinematics_.edge_of(pair);
        const double fastest =
            edge.is_seesaw
                ? fastest_point(edge.seesaw)
                : std::max(length(edge.start_velocity), length(edge.end_velocity)) * edge.share;
        return length(bodies_.displacement[pair.a]) + fastest * step_.duration;
    };
    for (const std::uint32_t p : classification_.ccd())
        if (shrinks(pairs_[p]) > pairs_[p].separation) candidates_.push_back(p);
    // Other pairs may collide only where something has moved a ball far off its free flight, or
    // where they overlap deeply.
    const bool may_sink_in =
        (!step_.trusts_constraints() && !classification_.constraints().empty()) ||
        classification_.deepest() < -contact_tolerance::deep_overlap * bodies_.smallest_radius;
    const auto consider = [&](std::uint32_t p) {
        const ContactPair& pair = pairs_[p];
        if (pair.state == ContactState::ccd) return;
        const double allowed =
            pair.state == ContactState::constraint ? soft_bound(step_, pair) : 0.0;
        if (shrinks(pair) > pair.separation + allowed) candidates_.push_back(p);
    };
    if (may_sink_in || 4 * pushed_.size() > bodies_.fixed) {
        for (std::uint32_t p = 0; p < pairs_.size(); ++p)
            consider(p);
        return;
    }
    if (pushed_.empty()) return;
    pairs_.list_by_body(bodies_);
    for (const std::uint32_t body : pushed_)
        for (const std::uint32_t p : pairs_.of_body(body))
            consider(p);
}

// Impacts cannot part a crowd of balls inside one another: each of them pushes others further in,
// until all are frozen. So balls that are embedded in others are left to constraints alone, except
// at edges.
void ContactImpacts::find_embedded() {
    is_embedded_.clear();
    if (classification_.deepest() >
        -contact_tolerance::embedded * contact_tolerance::overlap_limit * bodies_.smallest_radius)
        return;
    is_embedded_.assign(bodies_.fixed, 0);
    for (const std::uint32_t p : classification_.constraints()) {
        const ContactPair& pair = pairs_[p];
        if (is_embedded(bodies_, pair)) is_embedded_[pair.a] = is_embedded_[pair.b] = 1;
    }
}

bool ContactImpacts::find() {
    given_ = 0.0;
    of_balls_.clear();
    find_embedded();
    find_displacements();
    find_candidates();
    return !candidates_.empty() || !escaped_.empty() ||
           first_stop(kinematics_.edges()) < step_.duration;
}

void ContactImpacts::push_freeze(std::uint32_t body, std::optional<double> time) {
    if (!time) return;
    queue_.push({.time = *time,
                 .kind = ContactEvent::Kind::freeze,
                 .low = bodies_.ball[body],
                 .high = bodies_.ball[body],
                 .body = body,
                 .body_version = paths_[body].version});
}

void ContactImpacts::run(World& world, ContactHinges& hinges, std::vector<Contact>& contacts) {
    paths_.begin();
    kinematics_.for_each_held_ball([&](std::uint32_t body) { paths_.add(body); });
    queue_.clear();
    for (const std::uint32_t body : escaped_) {
        paths_.add(body);
        push_freeze(body, paths_.end_at_skin(body, 0.0));
    }
    for (const std::uint32_t p : candidates_) {
        const std::uint32_t body = pairs_[p].a;
        paths_.add(body);
        if (!paths_[body].is_surrounded) predict(world, body, 0.0);
    }
    while (true) {
        const double stop = first_stop(kinematics_.edges());
        if (stop < step_.duration && (queue_.is_empty() || stop <= queue_.first().time)) {
            turn_back_at_stops(world, stop);
            continue;
        }
        if (queue_.is_empty()) break;
        const ContactEvent event = queue_.pop();
        if (event.body_version != paths_[event.body].version) continue;
        if (event.kind == ContactEvent::Kind::freeze) {
            paths_.freeze(event.body, event.time);
            predict(world, event.body, event.time);
        } else if (is_void(event)) {
            predict(world, event.body, event.time);
        } else {
            collide(world, event, contacts);
        }
    }
    hinges.give_back(paths_);
    paths_.finish(world);
}

void ContactImpacts::turn_back_at_stops(const World& world, double now) {
    for (HeldEdge& edge : kinematics_.edges()) {
        if (!edge.is_seesaw || edge.time_of_stop() > now) continue;
        bounce_at_stops(std::span(&edge, 1), now);
        predict_at_edge(world, edge.capsule, now);
    }
}

void ContactImpacts::predict_at_edge(const World& world, std::uint32_t capsule, double now) {
    for (const std::uint32_t p : pairs_.kinematic())
        if (pairs_[p].edge == capsule) predict(world, pairs_[p].a, now);
}

// Whether the other body has changed its path since the prediction.
bool ContactImpacts::is_void(const ContactEvent& event) const {
    const ContactPair& pair = pairs_[event.pair];
    if (pair.b > bodies_.fixed) return kinematics_.edge_of(pair).version != event.other_version;
    if (pair.b == bodies_.fixed) return false;
    const std::uint32_t other = pair.a == event.body ? pair.b : pair.a;
    return paths_[other].version != event.other_version;
}

// The edge of a pair, where the ball sees it.
Capsule ContactImpacts::edge_at(const World& world, const ContactPair& pair, double now) const {
    if (pair.b > bodies_.fixed) return shape_at(kinematics_.edge_of(pair), world, now);
    Capsule shape = world.capsules().shape[pair.edge];
    if (step_.wraps) {
        const Vec2 shift{pair.across * step_.torus.x, pair.along * step_.torus.y};
        shape.start += shift;
        shape.end += shift;
    }
    return shape;
}

// Whether the pair may overlap up to its bound before it collides. A resting constraint may. So may
// a constraint that would not bounce, unless it overlaps deeply already: the rest of its approach
// is left to the iterations of the next substep, since a pile that falls together would take
// impacts without end.
bool ContactImpacts::is_soft(const ContactPair& pair, Vec2 other_velocity, double now) const {
    if (pair.has_settled) return true;
    if (pair.state != ContactState::constraint) return false;
    if ((!pair.bounces || classification_.is_enclosed(pair)) &&
        pair.separation > -contact_tolerance::soft_overlap * overlap_bound(pair))
        return true;
    return -dot(paths_.velocity_at(pair.a, now) - other_velocity, pair.normal) <= step_.rest_speed;
}

std::optional<double> ContactImpacts::time_of_impact(const World& world, const ContactPair& pair,
                                                     double now) const {
    const double left = step_.duration - now;
    const Vec2 at = paths_.chord_position(pair.a, now);
    const Vec2 chord = paths_.chord_velocity(pair.a, now);
    const double radius = bodies_.radius[pair.a];
    const auto allowed_overlap = [&](Vec2 other_velocity) {
        return is_soft(pair, other_velocity, now) ? soft_bound(step_, pair) : 0.0;
    };
    std::optional<Impact> impact;
    if (bodies_.is_ball(pair.b)) {
        if (!is_embedded_.empty() && is_embedded_[pair.a] && is_embedded_[pair.b])
            return std::nullopt;
        Vec2 offset = at - paths_.chord_position(pair.b, now);
        if (step_.wraps) offset = nearest_image(offset, step_.torus);
        impact = impact_of_balls(offset, chord - paths_.chord_velocity(pair.b, now), radius,
                                 bodies_.radius[pair.b], left,
                                 [&] { return allowed_overlap(paths_.velocity_at(pair.b, now)); });
    } else {
        const bool is_kinematic = pair.b > bodies_.fixed;
        const HeldEdge* const edge = is_kinematic ? &kinematics_.edge_of(pair) : nullptr;
        const Capsule shape = edge_at(world, pair, now);
        const Vec2 surface = is_kinematic ? bodies_.body[pair.b].velocity : Vec2{};
        const Disc disc{at, std::max(0.0, radius - allowed_overlap(surface))};
        impact = edge ? impact_with_moving_edge(disc, chord, shape, *edge, left)
                      : first_impact(disc, chord, shape, left);
        if (impact && !is_kinematic && world.model().one_way &&
            !is_on_solid_side(shape, world.capsules().side[pair.edge], at + chord * impact->time))
            return std::nullopt;
    }
    if (!impact) return std::nullopt;
    return now + impact->time;
}

// Puts the first impact of a body from now on into the queue.
void ContactImpacts::predict(const World& world, std::uint32_t body, double now) {
    paths_.add_around(body);
    const ContactPath& path = paths_[body];
    std::optional<ContactEvent> best;
    for (const std::uint32_t p : pairs_.of_body(body)) {
        const ContactPair& pair = pairs_[p];
        const auto time = time_of_impact(world, pair, now);
        if (!time || !(*time < step_.duration)) continue;
        const bool on_ball = bodies_.is_ball(pair.b);
        const std::uint32_t other = pair.a == body ? pair.b : pair.a;
        const ContactEvent event{
            .time = *time,
            .kind = on_ball ? ContactEvent::Kind::ball : ContactEvent::Kind::edge,
            .low = bodies_.ball[pair.a],
            .high = on_ball ? bodies_.ball[pair.b] : pair.edge,
            .body = body,
            .pair = p,
            .body_version = path.version,
            .other_version = on_ball                  ? paths_[other].version
                             : pair.b > bodies_.fixed ? kinematics_.edge_of(pair).version
                                                      : 0};
        if (!best || is_earlier(event, *best)) best = event;
    }
    if (best) queue_.push(*best);
}

}  // namespace carom
