#include <cmath>

#include "physics/laws/contact_material.h"
#include "physics/laws/hinge.h"
#include "physics/swept/response.h"
#include "physics/swept/tolerances.h"
#include "physics/world/solver_access.h"

// What an impact with a seesaw does in the solver `swept`.
namespace carom {

namespace {

// The acceleration along the normal of a ball that stays on the turning edge: Coriolis and
// centrifugal.
double following(const Seesaw& seesaw, Vec2 position, Vec2 velocity, Vec2 normal) {
    const Vec2 arm = position - seesaw.pivot;
    const Vec2 relative = velocity - perpendicular(arm) * seesaw.rate;
    return seesaw.rate *
           (2.0 * dot(perpendicular(relative), normal) - seesaw.rate * dot(arm, normal));
}

Contact contact_of(const SweptEvent& event, Vec2 point, double approach, double impulse) {
    return {.time = event.time,
            .kind = ContactKind::ball_edge,
            .a = event.ball,
            .b = event.other,
            .point = point,
            .normal = event.normal,
            .approach = approach,
            .impulse = impulse};
}

void apply_friction_on_seesaw(World& world, const SweptEvent& event, const HingeImpact& impact,
                              double impulse) {
    if (!world.model().spin) return;
    Balls& balls = SolverAccess(world).balls();
    apply_friction_on_hinge(impact, {balls.spin[event.ball], balls.radius[event.ball]}, impulse,
                            {friction_of_edge(world, event.other), *world.model().spin});
}

}  // namespace

// A ball whose flight after the bounce would lead back before the substep ends rests: what presses
// it for the rest of the substep acts at once, on the ball and through it on the seesaw. Then the
// ball follows the edge. That loses energy, as a step of Euler's method does that takes the
// velocity first. Where the edge turns so fast that following it takes more than a few times
// gravity, the ball bounces and does not rest: at once, that much would feed the seesaw.
SweptOutcome SweptResponse::collide_seesaw(World& world, const SweptEvent& event,
                                           const HeldEdge& edge) {
    const std::uint32_t ball = event.ball;
    const double now = event.time;
    const Vec2 normal = event.normal;
    const double radius = world.balls().radius[ball];
    const Vec2 point = paths_.position_at(ball, now) - normal * radius;
    if (world.model().spin) paths_.advance_spin(world, ball, now);
    const Vec2 start = paths_.velocity_at(world, ball, now);
    Vec2 velocity = start;
    Seesaw seesaw = edge.seesaw_at(now);
    const double rate = seesaw.rate;
    const HingeImpact impact =
        hinge_impact(velocity, paths_.inverse_mass(ball), seesaw, seesaw.rate, point, normal);
    const double approach = impact.approach();
    if (!(impact.compliance() > 0.0)) {
        // A held ball goes no further than the seesaw lets it.
        paths_.count_resting_impact(world, ball, {});
        redirect(world, ball, now, velocity + normal * approach);
        return {};
    }
    const bool is_held = paths_.is_held(ball);
    const double restitution =
        is_held ? hand_restitution
                : restitution_of_edge(world, event.other, std::max(0.0, approach));
    Exchange exchange{0.0, approach};
    if (approach > 0.0) exchange = bounce_on_hinge(impact, restitution);
    bool is_resting = false;
    double follow = 0.0;
    if (!is_held) {
        const Vec2 chord = paths_.chord_velocity(world, ball, velocity, step_.gravity, now);
        is_resting = dot(chord, normal) < seesaw.rate * impact.lever ||
                     (restitution < 1.0 && approach < step_.rest_speed);
        follow = following(edge.seesaw_at(now), point + normal * radius, start, normal);
        if (std::abs(follow) > swept_tolerance::seesaw_following * length(step_.gravity))
            is_resting = false;
    }
    if (is_resting) {
        velocity = start;
        seesaw.rate = rate;
        const double pull = std::min(0.0, dot(paths_.gravity_on(ball), normal) - follow);
        velocity += normal * (pull * (step_.duration - now));
        exchange.impulse = 0.0;
        if (impact.approach() > 0.0)
            exchange.impulse = bounce_on_hinge(impact, swept_tolerance::seesaw_restitution).impulse;
        if (pull < 0.0) paths_.rest_on(world, ball, normal, follow);
    } else if (approach > 0.0) {
        paths_.end_rest(ball);
    }
    apply_friction_on_seesaw(world, event, impact, exchange.impulse);
    if (is_resting || !(approach > 0.0)) paths_.count_resting_impact(world, ball, velocity);
    redirect(world, ball, now, velocity);
    kinematics_.turn(event.other, seesaw, now);
    SweptOutcome outcome{.contact = {}, .has_changed_edge = true};
    if (approach > 0.0 && !is_held)
        outcome.contact = contact_of(event, point, approach, exchange.impulse);
    return outcome;
}

}  // namespace carom
