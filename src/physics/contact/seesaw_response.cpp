#include <algorithm>

#include "geometry/closest.h"
#include "physics/contact/impacts.h"
#include "physics/contact/tolerances.h"
#include "physics/laws/contact_material.h"
#include "physics/laws/hinge.h"

// What an impact with a seesaw does within a substep of the solver `contact`.
namespace carom {

std::optional<Contact> ContactImpacts::collide_seesaw(World& world, ContactPair& pair, double now) {
    const std::uint32_t a = pair.a;
    HeldEdge& edge = kinematics_.edge_of(pair);
    const Vec2 position = paths_.position_at(a, now);
    const Capsule shape = edge_at(world, pair, now);
    const Vec2 normal =
        direction(position - closest_point(shape.start, shape.end, position), pair.normal);
    const Vec2 point = position - normal * bodies_.radius[a];
    Vec2 velocity = paths_.velocity_at(a, now);
    double surface_speed = paths_.surface_speed_at(a, now);
    Seesaw seesaw = edge.seesaw_at(now);
    const HingeImpact impact =
        hinge_impact(velocity, bodies_.body[a].inverse_mass, seesaw, seesaw.rate, point, normal);
    const double approach = impact.approach();
    if (!(impact.compliance() > 0.0)) {
        // A held ball goes no further than the seesaw lets it.
        pair.has_settled = true;
        redirect(a, now, velocity + normal * std::max(0.0, approach), surface_speed);
        return std::nullopt;
    }
    const double rounding =
        contact_tolerance::rounding * (length(velocity) + std::abs(seesaw.rate * impact.lever));
    const bool meets_again = pair.has_settled;
    const bool bounces = approach > std::max(rounding, step_.rest_speed) && !meets_again &&
                         !classification_.is_enclosed(pair);
    pair.has_settled = !bounces;
    Exchange done{0.0, approach};
    if (approach > 0.0) {
        const double restitution = bounces ? restitution_of(world, bodies_, pair, approach) : 0.0;
        done = bounce_on_hinge(impact, restitution);
        if (step_.spins)
            apply_friction_on_hinge(impact, {surface_speed, 1.0}, done.impulse,
                                    {pair.friction, *world.model().spin});
    }
    redirect(a, now, velocity, surface_speed);
    edge.turn(seesaw, now);
    if (!(approach > rounding)) {
        if (meets_again && edge.is_stopped()) paths_.freeze_at(a, normal, now);
        return std::nullopt;
    }
    return edge_contact(pair, position, normal, done, now);
}

}  // namespace carom
