#pragma once

#include "physics/laws/bounce.h"

/// What an impact within a substep does to velocities, where one body may be kinematic: for the
/// solvers `swept` and `contact`.
namespace carom {

/// A ball in an impact. A kinematic ball keeps its velocity and pushes: see bounce_off.
struct ImpactBall {
    Vec2& velocity;
    double inverse_mass = 0.0;
    bool is_kinematic = false;
};

/// Bounce of two balls. `normal` points from b to a. Pre: they approach, unless one is kinematic;
/// not both have an inverse mass of 0.
inline Exchange bounce_balls(const ImpactBall& a, const ImpactBall& b, Vec2 normal,
                             double restitution) {
    if (a.is_kinematic)
        return bounce_off(b.velocity, b.inverse_mass, -normal, dot(a.velocity, -normal),
                          restitution);
    if (b.is_kinematic)
        return bounce_off(a.velocity, a.inverse_mass, normal, dot(b.velocity, normal), restitution);
    return bounce(a.velocity, a.inverse_mass, b.velocity, b.inverse_mass, normal, restitution);
}

}  // namespace carom
