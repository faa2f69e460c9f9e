#pragma once

#include <algorithm>

#include "physics/laws/bounce.h"
#include "physics/world/seesaw.h"

/// The impact of a ball and a seesaw (world/seesaw.h), an edge on a hinge with a moment of inertia
/// I.
///
/// An impulse J along the normal n at the point p changes the ball's velocity by J/m and the rate
/// of the seesaw by -J c/I, with the lever arm c = (p - pivot) x n. So the approach falls by J (1/m
/// + c^2/I), and Newton's law asks for
///
///     J = (1 + e) approach / (1/m + c^2/I)
///
/// which keeps the angular momentum about the hinge, and with e = 1 the energy. Friction along the
/// tangent t has the lever arm (p - pivot) x t, and limits as between balls (laws/bounce.h).
/// Source: any mechanics text; the hinge takes up what it must.
namespace carom {

/// A ball and a seesaw at the instant at which they meet.
struct HingeImpact {
    Vec2& velocity;  ///< of the ball
    double inverse_mass = 0.0;
    double& rate;  ///< of the seesaw
    double inverse_inertia = 0.0;
    Vec2 normal;              ///< from the edge to the ball
    double lever = 0.0;       ///< of the normal
    double side_lever = 0.0;  ///< of perpendicular(normal)

    double approach() const { return rate * lever - dot(velocity, normal); }
    /// By how much an impulse of 1 changes the approach.
    double compliance() const { return inverse_mass + lever * lever * inverse_inertia; }
    void push(double impulse) const {
        velocity += normal * (impulse * inverse_mass);
        rate -= impulse * lever * inverse_inertia;
    }
};

/// The levers of the impact at `point`, and the inertia, which is infinite where the seesaw rests
/// at a stop that the ball presses it against.
inline HingeImpact hinge_impact(Vec2& velocity, double inverse_mass, const Seesaw& seesaw,
                                double& rate, Vec2 point, Vec2 normal) {
    const Vec2 arm = point - seesaw.pivot;
    const double lever = cross(arm, normal);
    const bool is_blocked = rate == 0.0 && is_stopped_at(seesaw, -lever);
    return {.velocity = velocity,
            .inverse_mass = inverse_mass,
            .rate = rate,
            .inverse_inertia = is_blocked ? 0.0 : 1.0 / seesaw.inertia,
            .normal = normal,
            .lever = lever,
            .side_lever = cross(arm, perpendicular(normal))};
}

/// Bounces the two. Pre: they approach, and one of them gives way.
inline Exchange bounce_on_hinge(const HingeImpact& impact, double restitution) {
    const double approach = impact.approach();
    const double impulse = (1.0 + restitution) * approach / impact.compliance();
    impact.push(impulse);
    return {impulse, approach};
}

/// Applies friction after the normal impulse. Returns the impulse along perpendicular(normal).
inline double apply_friction_on_hinge(const HingeImpact& impact, Rotation ball,
                                      double normal_impulse, Friction friction) {
    if (!(impact.inverse_mass > 0.0)) return 0.0;
    const Vec2 along = perpendicular(impact.normal);
    const double slip = dot(impact.velocity, along) - ball.surface_speed(impact.inverse_mass) -
                        impact.rate * impact.side_lever;
    const double yielding = impact.inverse_mass * (1.0 + 1.0 / friction.inertia) +
                            impact.side_lever * impact.side_lever * impact.inverse_inertia;
    const double most = friction.coefficient * std::max(0.0, normal_impulse);
    const double impulse = std::clamp(-slip / yielding, -most, most);
    impact.velocity += along * (impulse * impact.inverse_mass);
    impact.rate -= impulse * impact.side_lever * impact.inverse_inertia;
    ball.spin -= impulse * impact.inverse_mass / (friction.inertia * ball.radius);
    return impulse;
}

}  // namespace carom
