#pragma once

#include <algorithm>

#include "geometry/closest.h"
#include "geometry/elementary.h"
#include "physics/random.h"
#include "physics/terms.h"
#include "physics/world.h"

/// The bounce: what an impact does to velocities. Along the normal Newton's law of restitution
/// holds, across it nothing changes (no friction). Source: any mechanics text; the one-dimensional
/// pair is in docs/physics.md.
namespace carom {

/// Momentum that the contact passed, along its normal, and how fast the two closed.
struct Exchange {
    double impulse = 0.0;
    double approach = 0.0;
};

/// Velocities and inverse masses of two balls that meet; `normal` points from b to a. An inverse
/// mass of 0 is a body that nothing moves. Pre: they approach; not both immovable. `restitution` in
/// 0..1.
inline Exchange bounce(Vec2& velocity_a, double inverse_mass_a, Vec2& velocity_b,
                       double inverse_mass_b, Vec2 normal, double restitution) {
    const double approach = -dot(velocity_a - velocity_b, normal);
    const double impulse = (1.0 + restitution) * approach / (inverse_mass_a + inverse_mass_b);
    velocity_a += normal * (impulse * inverse_mass_a);
    velocity_b -= normal * (impulse * inverse_mass_b);
    return {impulse, approach};
}

/// A ball that a hand pushes leaves it a little faster than the hand, by this share of the
/// approach, so that a hand that turns or speeds up does not meet it again at once.
inline constexpr double hand_restitution = 0.05;

/// A ball against a body that nothing moves and whose surface moves at `surface` along the normal,
/// which is not 0 only where a hand moves it: the ball leaves as it would leave a still one, or
/// with the hand if that is faster.
inline Exchange bounce_off(Vec2& velocity, double inverse_mass, Vec2 normal, double surface,
                           double restitution) {
    const double speed = dot(velocity, normal);
    const double with_hand =
        surface > 0.0 ? surface + hand_restitution * (surface - speed) : surface;
    const double after = std::max(with_hand, -restitution * speed);
    velocity += normal * (after - speed);
    return {(after - speed) / inverse_mass, surface - speed};
}

/// Restitution of a ball and an edge of this material at this speed of approach.
inline double restitution_at(const Material& material, double approach) {
    return material.restitution / (1.0 + material.soften * approach);
}

/// The normal of ball `id`'s contact number `contact` with an edge, turned by its seeded angle. A
/// draw that would send the ball into the edge is drawn again, at most 16 times; then the normal
/// stays. `restitution` as in the bounce that follows.
Vec2 scattered_normal(const World& world, BallId id, std::uint32_t contact, Vec2 normal,
                      Vec2 velocity, double restitution);

/// Whether an edge pushes a ball whose centre is at `center`.
inline bool is_on_solid_side(const Capsule& capsule, Side side, Vec2 center) {
    if (side == Side::both) return true;
    const double left = cross(capsule.end - capsule.start, center - capsule.start);
    return side == Side::left ? left >= 0.0 : left <= 0.0;
}

}  // namespace carom
