#include "physics/swept/response.h"

#include <algorithm>
#include <cmath>

#include "physics/ccd/response.h"
#include "physics/laws/cloth_contact.h"
#include "physics/laws/contact_material.h"
#include "physics/swept/tolerances.h"
#include "physics/world/solver_access.h"

namespace carom {

SweptOutcome SweptResponse::collide(World& world, const SweptEvent& event) {
    if (event.kind == ContactKind::ball_ball) return {.contact = collide_balls(world, event)};
    return collide_edge(world, event);
}

std::optional<Contact> SweptResponse::collide_balls(World& world, const SweptEvent& event) {
    const std::uint32_t a = event.ball;
    const std::uint32_t b = event.other;
    const double now = event.time;
    const Vec2 normal = event.normal;
    BallImpact impact{.a = a, .b = b, .normal = normal, .now = now};
    impact.velocity_a = paths_.velocity_at(world, a, now);
    impact.velocity_b = paths_.velocity_at(world, b, now);
    if (world.model().spin) {
        paths_.advance_spin(world, a, now);
        paths_.advance_spin(world, b, now);
    }
    impact.inverse_a = paths_[a].is_frozen ? 0.0 : paths_.inverse_mass(a);
    impact.inverse_b = paths_[b].is_frozen ? 0.0 : paths_.inverse_mass(b);
    impact.approach = -dot(impact.velocity_a - impact.velocity_b, normal);
    const BallImpact before = impact;
    double most_lift = 0.0;
    if (step_.counts_lifts) most_lift = lifts(impact);
    const Passed passed = pass_between(world, impact);
    if (step_.counts_lifts) most_lift += energy_lost(before, impact);
    if (world.model().spin) apply_ball_friction(world, impact, passed);
    if (step_.counts_lifts) pay_for_lifts(impact, before, most_lift);
    const bool is_resting = passed.is_resting || !passed.is_contact;
    for (const std::uint32_t ball : {a, b}) {
        if (!is_resting) paths_.end_rest(ball);
        if (is_resting)
            paths_.count_resting_impact(world, ball,
                                        ball == a ? impact.velocity_a : impact.velocity_b);
    }
    if (world.model().cloth) {
        paths_.stop_sliding_if_pressed(world, a, impact.velocity_a);
        paths_.stop_sliding_if_pressed(world, b, impact.velocity_b);
    }
    redirect(world, a, now, impact.velocity_a);
    redirect(world, b, now, impact.velocity_b);
    if (!passed.is_contact) return std::nullopt;
    return Contact{.time = now,
                   .kind = ContactKind::ball_ball,
                   .a = std::min(a, b),
                   .b = std::max(a, b),
                   .point = paths_.position_at(b, now) + normal * world.balls().radius[b],
                   .normal = a < b ? normal : -normal,
                   .approach = passed.exchange.approach,
                   .impulse = passed.exchange.impulse};
}

SweptResponse::Passed SweptResponse::pass_between(const World& world, BallImpact& impact) {
    const double restitution = restitution_of_balls(world, impact.a, impact.b);
    const bool is_pushed = paths_.is_held(impact.a) || paths_.is_held(impact.b);
    const bool is_slow = restitution < 1.0 && impact.approach < step_.rest_speed;
    if (impact.inverse_a == 0.0 && impact.inverse_b == 0.0) {
        // A held ball goes no further towards a frozen one.
        if (paths_.is_held(impact.a) && !paths_[impact.a].is_frozen)
            impact.velocity_a += impact.normal * impact.approach;
        else
            impact.velocity_b -= impact.normal * impact.approach;
        return {{0.0, impact.approach}, is_pushed || is_slow, false};
    }
    if (is_pushed) {
        const ImpactBall a{impact.velocity_a, impact.inverse_a, paths_.is_held(impact.a)};
        const ImpactBall b{impact.velocity_b, impact.inverse_b, paths_.is_held(impact.b)};
        return {bounce_balls(a, b, impact.normal, restitution), true, true};
    }
    if (is_slow) return rest_together(world, impact);
    Exchange exchange{0.0, impact.approach};
    Vec2 after_a = impact.velocity_a;
    Vec2 after_b = impact.velocity_b;
    if (impact.approach > 0.0)
        exchange = bounce(after_a, impact.inverse_a, after_b, impact.inverse_b, impact.normal,
                          restitution);
    if (meet_again(world, impact, after_a, after_b)) return rest_together(world, impact);
    impact.velocity_a = after_a;
    impact.velocity_b = after_b;
    return {exchange, false, impact.approach > 0.0};
}

// Whether the chords of two balls that leave the impact at these velocities approach again.
bool SweptResponse::meet_again(const World& world, const BallImpact& impact, Vec2 velocity_a,
                               Vec2 velocity_b) const {
    const auto chord = [&](std::uint32_t ball, Vec2 velocity) {
        if (paths_[ball].is_frozen || paths_.is_held(ball)) return velocity;
        return paths_.chord_velocity(world, ball, velocity, paths_.gravity_on(ball), impact.now);
    };
    const Vec2 chord_a = chord(impact.a, velocity_a);
    const Vec2 chord_b = chord(impact.b, velocity_b);
    return -dot(chord_a - chord_b, impact.normal) >
           swept_tolerance::rounding * (length(chord_a) + length(chord_b));
}

// A ball that comes to rest on a grounded one does not push it down, except where that would add
// energy.
SweptResponse::Passed SweptResponse::rest_together(const World& world, BallImpact& impact) {
    const SweptPath& a = paths_[impact.a];
    const SweptPath& b = paths_[impact.b];
    const double speed_a = std::fabs(dot(impact.velocity_a, impact.normal));
    const double speed_b = std::fabs(dot(impact.velocity_b, impact.normal));
    const double up = world.model().gravity ? -dot(impact.normal, step_.gravity) : 0.0;
    const bool on_b = up > 0.0 && b.is_grounded && !a.is_frozen && speed_b <= speed_a;
    const bool on_a = up < 0.0 && a.is_grounded && !b.is_frozen && speed_a <= speed_b;
    const Exchange exchange =
        bounce(impact.velocity_a, on_a ? 0.0 : impact.inverse_a, impact.velocity_b,
               on_b ? 0.0 : impact.inverse_b, impact.normal,
               impact.approach > 0.0 ? swept_tolerance::resting_restitution : 0.0);
    if (up > 0.0 && b.is_grounded) paths_.rest_on(world, impact.a, impact.normal);
    if (up < 0.0 && a.is_grounded) paths_.rest_on(world, impact.b, -impact.normal);
    return {exchange, true, impact.approach > 0.0};
}

void SweptResponse::apply_ball_friction(World& world, BallImpact& impact,
                                        const Passed& passed) const {
    Balls& balls = SolverAccess(world).balls();
    const std::uint32_t a = impact.a;
    const std::uint32_t b = impact.b;
    double pressed = passed.is_contact ? passed.exchange.impulse : 0.0;
    if (passed.is_resting && world.model().gravity) {
        // The weight of the upper ball, for the rest of the substep.
        const double up = -dot(step_.gravity, impact.normal);
        const double inverse = paths_.inverse_mass(up > 0.0 ? a : b);
        if (inverse > 0.0) pressed += std::fabs(up) * (step_.duration - impact.now) / inverse;
    }
    const Friction friction{friction_of_balls(world, a, b), *world.model().spin};
    if (world.model().cloth)
        apply_cloth_friction(impact.velocity_a, roller(balls, a), impact.inverse_a,
                             impact.velocity_b, roller(balls, b), impact.inverse_b, impact.normal,
                             pressed, friction);
    else
        apply_friction(impact.velocity_a, {balls.spin[a], balls.radius[a]}, impact.inverse_a,
                       impact.velocity_b, {balls.spin[b], balls.radius[b]}, impact.inverse_b,
                       impact.normal, pressed, friction);
}

SweptOutcome SweptResponse::collide_edge(World& world, const SweptEvent& event) {
    const std::uint32_t ball = event.ball;
    const double now = event.time;
    const HeldEdge* const edge = kinematics_.find(event.other);
    if (paths_[ball].is_frozen) {
        // Nothing can move this ball: the kinematic edge that comes against it stops.
        if (edge) kinematics_.stop(event.other, now);
        return {std::nullopt, edge != nullptr};
    }
    if (edge && edge->is_seesaw) return collide_seesaw(world, event, *edge);
    EdgeImpact impact{.ball = ball, .capsule = event.other, .normal = event.normal, .now = now};
    impact.position = paths_.position_at(ball, now);
    impact.along = event.normal;
    if (edge) {
        impact.surface =
            surface_velocity(*edge, carom::shape_at(*edge, world, now), impact.position);
        impact.pushing = dot(impact.surface, event.normal);
        impact.is_driven = edge->is_driven;
    }
    impact.velocity = paths_.velocity_at(world, ball, now);
    if (world.model().spin) paths_.advance_spin(world, ball, now);
    impact.approach = impact.pushing - dot(impact.velocity, event.normal);
    if (paths_.is_held(ball)) {
        // It goes no further than the edge lets it.
        paths_.count_resting_impact(world, ball, {});
        redirect(world, ball, now, impact.velocity + event.normal * impact.approach);
        return {};
    }
    return {.contact = collide_free_ball(world, impact)};
}

std::optional<Contact> SweptResponse::collide_free_ball(World& world, EdgeImpact& impact) {
    const std::uint32_t ball = impact.ball;
    const double approach = impact.approach;
    const Vec2 before = impact.velocity;
    double most_lift = 0.0;
    if (step_.counts_lifts) most_lift = lift(ball, before, impact.now);
    const Passed passed = bounce_off_edge(world, impact);
    if (step_.counts_lifts) most_lift += energy_lost(ball, before, impact.velocity);
    if (passed.rolls_on) paths_.end_rest(ball);
    if (world.model().spin && !passed.is_resting)
        apply_edge_friction(world, impact, passed.exchange.impulse);
    if (passed.is_resting) {
        paths_.rest_on(world, ball, impact.normal);
        if (world.model().spin) {
            apply_edge_friction(world, impact, passed.exchange.impulse);
            if (paths_[ball].is_resting && paths_.rest(ball).support == impact.normal)
                paths_.apply_rest_friction(world, ball, impact.surface,
                                           friction_of_edge(world, impact.capsule), impact.now,
                                           impact.velocity);
        }
    } else if (approach > 0.0) {
        paths_.end_rest(ball);
    }
    if (step_.counts_lifts) pay_for_lift(impact, before, most_lift, world.balls().radius[ball]);
    const bool is_thrown = impact.is_driven && impact.pushing > 0.0;
    if ((passed.is_resting && !is_thrown && !passed.rolls_on) || !(approach > 0.0))
        paths_.count_resting_impact(world, ball, impact.velocity);
    if (world.model().cloth) paths_.stop_sliding_if_pressed(world, ball, impact.velocity);
    redirect(world, ball, impact.now, impact.velocity);
    if (!(approach > 0.0)) return std::nullopt;
    return Contact{.time = impact.now,
                   .kind = ContactKind::ball_edge,
                   .a = ball,
                   .b = impact.capsule,
                   .point = impact.position - impact.normal * world.balls().radius[ball],
                   .normal = impact.along,
                   .approach = passed.exchange.approach,
                   .impulse = passed.exchange.impulse};
}

SweptResponse::Passed SweptResponse::bounce_off_edge(World& world, EdgeImpact& impact) const {
    const double approach = impact.approach;
    const double restitution = restitution_of_edge(world, impact.capsule, std::max(0.0, approach));
    const bool is_pushed = impact.pushing > 0.0 && !impact.is_driven;
    CurveBounce curve;
    if (world.model().curved && !kinematics_.find(impact.capsule)) {
        curve = bounce_off_curve(world, impact, restitution);
        if (curve.way == CurveBounce::Way::rolls_on) return roll_on(impact);
    }
    if (is_pushed || (restitution < 1.0 && approach < step_.rest_speed))
        return {rest_on_edge(impact, restitution), true};
    const std::uint32_t ball = impact.ball;
    Vec2 after = impact.velocity;
    Exchange exchange{0.0, approach};
    if (approach > 0.0) {
        const Vec2 normal = curve.way == CurveBounce::Way::bounces ? curve.normal : impact.normal;
        impact.along = bounce_normal(world, ball, normal, impact.velocity, restitution);
        exchange = bounce_off(after, paths_.inverse_mass(ball), impact.along, impact.pushing,
                              restitution, impact.is_driven);
        if (world.model().kicks)
            after +=
                impact.along * kick_of_edge(world, impact.capsule,
                                            kinematics_.shape_at(world, impact.capsule, impact.now),
                                            impact.position, approach);
    }
    const Vec2 chord = paths_.chord_velocity(world, ball, after, step_.gravity, impact.now);
    if (dot(chord, impact.normal) < impact.pushing) {
        if (curve.is_flat) return roll_on(impact);
        impact.along = impact.normal;
        return {rest_on_edge(impact, restitution), true};
    }
    impact.velocity = after;
    return {exchange, false};
}

CurveBounce SweptResponse::bounce_off_curve(const World& world, const EdgeImpact& impact,
                                            double restitution) const {
    return curve_bounce(
        world, impact.capsule,
        {.position = impact.position,
         .velocity = impact.velocity,
         .normal = impact.normal,
         .reach = world.balls().radius[impact.ball] + world.capsules().shape[impact.capsule].radius,
         .restitution = restitution});
}

// Turns the velocity along the piece of a curve, and away from it by a hair, as at rest.
SweptResponse::Passed SweptResponse::roll_on(EdgeImpact& impact) const {
    impact.along = rolling_normal(impact.velocity, impact.normal);
    const Exchange exchange =
        bounce_off(impact.velocity, paths_.inverse_mass(impact.ball), impact.along, 0.0, 1.0);
    impact.velocity += impact.normal * (impact.approach * swept_tolerance::resting_restitution);
    return {.exchange = exchange, .is_resting = true, .rolls_on = true};
}

// Removes the approach.
Exchange SweptResponse::rest_on_edge(EdgeImpact& impact, double restitution) const {
    const double inverse_mass = paths_.inverse_mass(impact.ball);
    if (impact.pushing > 0.0)
        return bounce_off(impact.velocity, inverse_mass, impact.normal, impact.pushing,
                          impact.is_driven ? 0.0 : restitution, impact.is_driven);
    const double change = impact.approach > 0.0
                              ? impact.approach * (1.0 + swept_tolerance::resting_restitution)
                              : impact.approach;
    impact.velocity += impact.normal * change;
    return {change / inverse_mass, impact.approach};
}

void SweptResponse::apply_edge_friction(World& world, EdgeImpact& impact, double impulse) const {
    Balls& balls = SolverAccess(world).balls();
    const std::uint32_t i = impact.ball;
    const double inverse_mass = paths_.inverse_mass(i);
    const Friction friction{friction_of_edge(world, impact.capsule), *world.model().spin};
    if (world.model().cloth)
        apply_cloth_friction_on_edge(impact.velocity, roller(balls, i), inverse_mass, impact.normal,
                                     impact.surface, impulse, friction);
    else
        apply_friction_on_surface(impact.velocity, {balls.spin[i], balls.radius[i]}, inverse_mass,
                                  impact.normal, impact.surface, impulse, friction);
}

}  // namespace carom
