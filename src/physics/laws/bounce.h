#pragma once

#include <algorithm>

#include "geometry/closest.h"
#include "geometry/elementary.h"
#include "physics/world/random.h"
#include "physics/world/terms.h"
#include "physics/world/world.h"

/// The bounce: what an impact does to velocities. Along the normal Newton's law of restitution
/// holds (`bounce`, `bounce_off`); across it nothing changes, unless the scene has friction: then
/// `rub` or `rub_on` comes after. Source: any mechanics text; the one-dimensional pair is in
/// docs/physics.md.
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

/// A ball leaves what a coil drives faster than its surface by at least this share of the surface's
/// speed. A ball that lies on a flipper as it turns is pressed on by what it gains, and would meet
/// it again and again, ever more softly: so it hops along, a few times a tick at most.
inline constexpr double driven_lift = 0.02;

/// What is left of a ball's approach to a driven surface, as a share of it. Pre: approach > 0.
inline double driven_restitution(double restitution, double surface, double approach) {
    return std::max(restitution, driven_lift * surface / approach);
}

/// A ball against a body that nothing moves and whose surface moves at `surface` along the normal,
/// which is not 0 only where a hand or a coil moves it. From a hand the ball leaves as it would
/// leave a still body, or with the hand if that is faster. What a coil drives (`is_driven`) throws,
/// as a wall that moves.
inline Exchange bounce_off(Vec2& velocity, double inverse_mass, Vec2 normal, double surface,
                           double restitution, bool is_driven = false) {
    const double speed = dot(velocity, normal);
    if (is_driven) {
        const double approach = surface - speed;
        const double change = (1.0 + driven_restitution(restitution, surface, approach)) * approach;
        velocity += normal * change;
        return {change / inverse_mass, approach};
    }
    const double with_hand =
        surface > 0.0 ? surface + hand_restitution * (surface - speed) : surface;
    const double after = std::max(with_hand, -restitution * speed);
    velocity += normal * (after - speed);
    return {(after - speed) / inverse_mass, surface - speed};
}

/// A ball that turns, at a contact with friction: its spin, rad/s, counter-clockwise, and radius.
struct Rim {
    double& spin;
    double radius;
};

/// Coulomb's law at one contact.
struct Friction {
    double coefficient = 0.0;  ///< mu >= 0
    double inertia = 0.5;      ///< moment of inertia / (m r^2) of every ball: Model::spin
};

/// Friction of two balls, after `pressed` >= 0 has passed along `normal`, which points from b to a.
///
/// The points that touch slip past one another along t = perpendicular(normal) at
///     u = (v_a - v_b) . t - (r_a w_a + r_b w_b).
/// With I = inertia m r^2 it takes the impulse -u / ((1/m_a + 1/m_b) (1 + 1/inertia)) along t to
/// stop that; friction passes it, but no more than coefficient * pressed either way: the points
/// stick, or slip on. It never turns the slip round, so it never makes energy, and what one ball
/// gains in momentum and angular momentum the other loses. Returns the impulse on a along t.
///
/// An inverse mass of 0 is a body that nothing moves or turns. Both 0: nothing happens.
/// Source: Coulomb's law in impulses, as in Walton's model of rough spheres without tangential
/// restitution (Walton and Braun, J. Rheology 30 (1986) 949; Foerster et al., Phys. Fluids 6 (1994)
/// 1108).
inline double rub(Vec2& velocity_a, Rim a, double inverse_mass_a, Vec2& velocity_b, Rim b,
                  double inverse_mass_b, Vec2 normal, double pressed, Friction friction) {
    const double inverse = inverse_mass_a + inverse_mass_b;
    if (!(inverse > 0.0)) return 0.0;
    const Vec2 along = perpendicular(normal);
    const double slip =
        dot(velocity_a - velocity_b, along) - (a.radius * a.spin + b.radius * b.spin);
    const double most = friction.coefficient * std::max(0.0, pressed);
    const double stopping = -slip / (inverse * (1.0 + 1.0 / friction.inertia));
    const double impulse = std::clamp(stopping, -most, most);
    velocity_a += along * (impulse * inverse_mass_a);
    velocity_b -= along * (impulse * inverse_mass_b);
    a.spin -= impulse * inverse_mass_a / (friction.inertia * a.radius);
    b.spin -= impulse * inverse_mass_b / (friction.inertia * b.radius);
    return impulse;
}

/// The same for a ball on a body that nothing moves and whose surface goes along at `surface`,
/// which is not 0 only where a hand moves it; there friction may speed the ball up, never beyond
/// the hand.
inline double rub_on(Vec2& velocity, Rim rim, double inverse_mass, Vec2 normal, Vec2 surface,
                     double pressed, Friction friction) {
    Vec2 moved = surface;
    double still = 0.0;
    return rub(velocity, rim, inverse_mass, moved, {still, 1.0}, 0.0, normal, pressed, friction);
}

/// Friction between balls of two kinds.
inline double friction_between(const Kind& a, const Kind& b) {
    return std::sqrt(a.friction * b.friction);
}

/// Restitution of a ball and an edge of this material at this speed of approach.
inline double restitution_at(const Material& material, double approach) {
    return material.restitution / (1.0 + material.soften * approach);
}

/// What an edge that kicks adds along the normal, length/s, on top of the bounce of a ball that
/// comes at `approach` and touches it nearest to `point`.
inline double kick_at(const Material& material, const Capsule& shape, Vec2 point, double approach) {
    if (!(material.kick > 0.0) || approach < material.kick_from) return 0.0;
    if (!material.kicks_in_the_middle) return material.kick;
    const double along = closest_parameter(shape.start, shape.end, point);
    return material.kick * 4.0 * along * (1.0 - along);
}

/// The normal of ball `id`'s contact number `contact` with an edge, turned by its seeded angle. A
/// draw that would send the ball into the edge is drawn again, at most 16 times; then the normal
/// stays. `restitution` as in the bounce that follows.
Vec2 scattered_normal(const World& world, BallId id, std::uint32_t contact, Vec2 normal,
                      Vec2 velocity, double restitution);

/// Whether an edge pushes a ball whose centre is at `center`. One on the line of a one-way edge has
/// not come to its solid side yet: from behind, it passes.
inline bool is_on_solid_side(const Capsule& capsule, Side side, Vec2 center) {
    if (side == Side::both) return true;
    if (side == Side::none) return false;
    const double left = cross(capsule.end - capsule.start, center - capsule.start);
    return side == Side::left ? left > 0.0 : left < 0.0;
}

}  // namespace carom
