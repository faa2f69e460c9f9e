#include <algorithm>

#include "geometry/closest.h"
#include "physics/ccd/response.h"
#include "physics/contact/impacts.h"
#include "physics/contact/tolerances.h"
#include "physics/laws/contact_material.h"

// What an impact within a substep of the solver `contact` does to the two bodies that meet.
namespace carom {

// After an impact.
void ContactImpacts::redirect(std::uint32_t body, double now, Vec2 velocity, double surface_speed) {
    if (!bodies_.is_kinematic(body)) {
        const Vec2 before = paths_.velocity_at(body, now);
        double squares = length_squared(velocity) - length_squared(before);
        if (step_.spins) {
            const double surface_before = paths_.surface_speed_at(body, now);
            squares +=
                (surface_speed * surface_speed - surface_before * surface_before) / step_.spin_ease;
        }
        given_ += 0.5 * squares / bodies_.body[body].inverse_mass;
    }
    push_freeze(body, paths_.redirect(body, now, velocity, surface_speed));
}

void ContactImpacts::collide(World& world, const ContactEvent& event,
                             std::vector<Contact>& contacts) {
    ContactPair& pair = pairs_[event.pair];
    const std::uint32_t a = pair.a;
    const std::uint32_t b = pair.b;
    const double now = event.time;
    if (b > bodies_.fixed && paths_[a].is_frozen) {
        stop_edge(world, pair, now);
        return;
    }
    const bool on_ball = bodies_.is_ball(b);
    const auto contact = on_ball          ? collide_balls(world, pair, now)
                         : pair.is_hinged ? collide_seesaw(world, pair, now)
                                          : collide_edge(world, pair, now);
    if (contact) {
        pair.is_new = false;
        contacts.push_back(*contact);
        contacts.back().time += step_.start_time;
    }
    if (pair.is_hinged) return predict_at_edge(world, pair.edge, now);
    predict(world, a, now);
    if (on_ball) predict(world, b, now);
}

std::optional<Contact> ContactImpacts::collide_balls(World& world, ContactPair& pair, double now) {
    const std::uint32_t a = pair.a;
    const std::uint32_t b = pair.b;
    Vec2 offset = paths_.position_at(a, now) - paths_.position_at(b, now);
    if (step_.wraps) offset = nearest_image(offset, step_.torus);
    const Vec2 normal = direction(offset, pair.normal);
    Vec2 velocity_a = paths_.velocity_at(a, now);
    Vec2 velocity_b = paths_.velocity_at(b, now);
    double surface_a = paths_.surface_speed_at(a, now);
    double surface_b = paths_.surface_speed_at(b, now);
    const ImpactBall first{velocity_a, bodies_.body[a].inverse_mass, bodies_.is_kinematic(a)};
    const ImpactBall second{velocity_b, bodies_.body[b].inverse_mass, bodies_.is_kinematic(b)};
    const double approach = -dot(velocity_a - velocity_b, normal);
    const double rounding = contact_tolerance::rounding * (length(velocity_a) + length(velocity_b));
    const bool meets_again = pair.has_settled;
    const bool bounces = approach > std::max(rounding, step_.rest_speed) && !meets_again &&
                         !classification_.is_enclosed(pair);
    pair.has_settled = !bounces;
    const double restitution = bounces ? restitution_of(world, bodies_, pair, approach) : 0.0;
    Exchange done{0.0, approach};
    if (first.is_kinematic || second.is_kinematic || approach > 0.0)
        done = bounce_balls(first, second, normal, restitution);
    if (step_.spins)
        apply_friction(velocity_a, {surface_a, 1.0}, first.inverse_mass, velocity_b,
                       {surface_b, 1.0}, second.inverse_mass, normal, done.impulse,
                       {pair.friction, *world.model().spin});
    redirect(a, now, velocity_a, surface_a);
    redirect(b, now, velocity_b, surface_b);
    if (!first.is_kinematic && !second.is_kinematic) of_balls_.push_back({a, b});
    if (first.is_kinematic) paths_.count_push(b, now);
    if (second.is_kinematic) paths_.count_push(a, now);
    if (!(approach > rounding)) {
        if (meets_again) {
            paths_.freeze_pushed(a, b, -normal, now);
            paths_.freeze_pushed(b, a, normal, now);
        }
        return std::nullopt;
    }
    return Contact{.time = now,
                   .kind = ContactKind::ball_ball,
                   .a = bodies_.ball[a],
                   .b = bodies_.ball[b],
                   .point = paths_[b].chord.position + normal * bodies_.radius[b],
                   .normal = normal,
                   .approach = done.approach,
                   .impulse = done.impulse};
}

Contact ContactImpacts::edge_contact(const ContactPair& pair, Vec2 position, Vec2 normal,
                                     Exchange done, double now) const {
    return {.time = now,
            .kind = ContactKind::ball_edge,
            .a = bodies_.ball[pair.a],
            .b = pair.edge,
            .point = position - normal * bodies_.radius[pair.a],
            .normal = normal,
            .approach = done.approach,
            .impulse = done.impulse};
}

std::optional<Contact> ContactImpacts::collide_edge(World& world, ContactPair& pair, double now) {
    const std::uint32_t a = pair.a;
    const Vec2 position = paths_.position_at(a, now);
    const Capsule shape = edge_at(world, pair, now);
    const Vec2 normal =
        direction(position - closest_point(shape.start, shape.end, position), pair.normal);
    const HeldEdge* const edge = pair.b > bodies_.fixed ? &kinematics_.edge_of(pair) : nullptr;
    const Vec2 surface = edge ? surface_velocity(*edge, shape, position) : Vec2{};
    const bool is_driven = edge && edge->is_driven;
    const double along_normal = dot(surface, normal);
    Vec2 velocity = paths_.velocity_at(a, now);
    double surface_speed = paths_.surface_speed_at(a, now);
    const double approach = along_normal - dot(velocity, normal);
    const double rounding = contact_tolerance::rounding * (length(velocity) + length(surface));
    if (bodies_.is_kinematic(a)) {
        // A held ball goes no further than the edge lets it.
        pair.has_settled = true;
        redirect(a, now, velocity + normal * std::max(0.0, approach), surface_speed);
        return std::nullopt;
    }
    const CurveBounce curve = bounce_off_curve(world, pair, normal, now);
    if (curve.way == CurveBounce::Way::rolls_on) return roll_on(world, pair, normal, now);
    const double inverse_mass = bodies_.body[a].inverse_mass;
    const double least = std::max(rounding, along_normal > 0.0 ? 0.0 : step_.rest_speed);
    const bool meets_again = pair.has_settled;
    const bool bounces = approach > least && !meets_again && !classification_.is_enclosed(pair);
    pair.has_settled = !bounces;
    Vec2 along = normal;
    Exchange done{0.0, approach};
    if (approach > 0.0) {
        const double restitution = bounces ? restitution_of(world, bodies_, pair, approach) : 0.0;
        if (bounces) {
            if (curve.way == CurveBounce::Way::bounces) along = curve.normal;
            along = bounce_normal(world, bodies_.ball[a], along, velocity, restitution);
        }
        done =
            bounce_off(velocity, inverse_mass, along, dot(surface, along), restitution, is_driven);
        if (bounces && world.model().kicks)
            velocity += along * kick_of_edge(world, pair.edge, shape, position, approach);
        if (step_.spins)
            apply_friction_on_surface(velocity, {surface_speed, 1.0}, inverse_mass, along, surface,
                                      done.impulse, {pair.friction, *world.model().spin});
    }
    redirect(a, now, velocity, surface_speed);
    if (along_normal > 0.0 && !is_driven) paths_.count_push(a, now);
    if (!(approach > rounding)) {
        if (meets_again && !edge) paths_.freeze_at(a, normal, now);
        return std::nullopt;
    }
    Contact contact = edge_contact(pair, position, normal, done, now);
    contact.normal = along;
    return contact;
}

// How a ball bounces off an edge that may be a piece of a curve. Where it does not leave it for the
// rest of the substep, it rolls on.
CurveBounce ContactImpacts::bounce_off_curve(const World& world, const ContactPair& pair,
                                             Vec2 normal, double now) const {
    if (!world.model().curved || pair.b != bodies_.fixed) return {};
    const double then = paths_.rolling_time(pair.a, now);
    const Vec2 velocity = paths_.velocity_at(pair.a, then);
    const double approach = -dot(velocity, normal);
    const CurveImpact impact{
        .position = paths_.position_at(pair.a, now),
        .velocity = velocity,
        .normal = normal,
        .reach = bodies_.radius[pair.a] + world.capsules().shape[pair.edge].radius,
        .restitution = restitution_of(world, bodies_, pair, std::max(0.0, approach))};
    CurveBounce bounce = curve_bounce(world, pair.edge, impact);
    const bool stays = then > now || approach <= step_.rest_speed;
    if (bounce.is_flat && stays) bounce.way = CurveBounce::Way::rolls_on;
    return bounce;
}

std::optional<Contact> ContactImpacts::roll_on(const World& world, ContactPair& pair, Vec2 normal,
                                               double now) {
    const std::uint32_t a = pair.a;
    const double then = paths_.rolling_time(a, now);
    Vec2 velocity = paths_.velocity_at(a, then);
    double surface_speed = paths_.surface_speed_at(a, then);
    const double approach = -dot(velocity, normal);
    const double inverse_mass = bodies_.body[a].inverse_mass;
    const Exchange done =
        bounce_off(velocity, inverse_mass, rolling_normal(velocity, normal), 0.0, 1.0);
    if (step_.spins)
        apply_friction_on_surface(velocity, {surface_speed, 1.0}, inverse_mass, normal, {},
                                  done.impulse, {pair.friction, *world.model().spin});
    pair.has_settled = true;
    const Vec2 position = paths_.position_at(a, now);
    push_freeze(a, paths_.roll_on(a, now, velocity, surface_speed, normal));
    return edge_contact(pair, position, normal, {done.impulse, approach}, now);
}

// A frozen ball is in the way of a kinematic edge, which stops for the rest of the substep.
void ContactImpacts::stop_edge(const World& world, const ContactPair& pair, double now) {
    kinematics_.edge_of(pair).stop(now);
    predict_at_edge(world, pair.edge, now);
}

}  // namespace carom
