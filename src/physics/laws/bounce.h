#pragma once

#include <algorithm>

#include "geometry/closest.h"
#include "geometry/elementary.h"
#include "physics/world/random.h"
#include "physics/world/terms.h"
#include "physics/world/world.h"

/// The bounce: how an impact changes velocities. Newton's law of restitution holds along the normal
/// (`bounce`, `bounce_off`). The tangential velocity changes only in scenes with friction, by
/// `apply_friction` or `apply_friction_on_surface` afterwards. Source: any mechanics text;
/// docs/physics.md derives the one-dimensional case.
namespace carom {

/// The impulse along the normal, and the approach speed before it, length/s.
struct Exchange {
    double impulse = 0.0;
    double approach = 0.0;
};

/// Bounces two balls. `normal` points from b to a. Inverse mass 0: an immovable body.
/// Pre: not both are immovable; `restitution` in 0..1; they approach, or `restitution` is 0. Then
/// balls that do not approach are pulled together along the normal, which loses energy. That is how
/// `swept` lets a ball rest on another when their velocities separate but their chords approach.
inline Exchange bounce(Vec2& velocity_a, double inverse_mass_a, Vec2& velocity_b,
                       double inverse_mass_b, Vec2 normal, double restitution) {
    const double approach = -dot(velocity_a - velocity_b, normal);
    const double impulse = (1.0 + restitution) * approach / (inverse_mass_a + inverse_mass_b);
    velocity_a += normal * (impulse * inverse_mass_a);
    velocity_b -= normal * (impulse * inverse_mass_b);
    return {impulse, approach};
}

/// A ball leaves a held body that pushes it a little faster than the body moves, by this share of
/// the approach speed. Otherwise a held body that turns or speeds up would hit it again at once.
inline constexpr double hand_restitution = 0.05;

/// A ball leaves a motorised surface faster than the surface moves, by at least this share of the
/// surface's speed. A ball lying on a turning flipper would otherwise hit it again and again, ever
/// more softly; so it hops along, a few times a tick at most.
inline constexpr double driven_lift = 0.02;

/// Under `event` a ball that gravity presses on a motorised surface leaves it so that it rises by
/// at least this share of its radius. It lies on a slow lift so, without impacts without end.
/// x10: it hops visibly; /10: its impacts count as a jam (quick_succession, event/motion).
inline constexpr double driven_lift_height = 5e-4;

/// The coefficient of restitution of a ball and a motorised surface. Pre: approach is not 0.
inline double driven_restitution(double restitution, double surface, double approach) {
    return std::max(restitution, driven_lift * surface / approach);
}

/// Bounces a ball off an immovable body whose surface moves at `surface` along the normal,
/// length/s; that is 0 unless the body is kinematic. A held body gives the ball the velocity that a
/// fixed one would, or its own if that is faster. A motorised one (`is_driven`) throws it, like a
/// moving wall; a ball that moves along with it is lifted off. Pre: `inverse_mass` > 0.
inline Exchange bounce_off(Vec2& velocity, double inverse_mass, Vec2 normal, double surface,
                           double restitution, bool is_driven = false) {
    const double speed = dot(velocity, normal);
    if (is_driven) {
        const double approach = surface - speed;
        const double change =
            approach == 0.0 ? driven_lift * std::max(surface, 0.0)
                            : (1.0 + driven_restitution(restitution, surface, approach)) * approach;
        velocity += normal * change;
        return {change / inverse_mass, approach};
    }
    const double with_hand =
        surface > 0.0 ? surface + hand_restitution * (surface - speed) : surface;
    const double after = std::max(with_hand, -restitution * speed);
    velocity += normal * (after - speed);
    return {(after - speed) / inverse_mass, surface - speed};
}

/// The rotation of a ball at a contact with friction: spin, rad/s, counter-clockwise, and radius.
struct Rotation {
    double& spin;
    double radius;

    /// Speed of its surface, length/s. An immovable ball does not turn: its spin would drive all
    /// that it touches, and never end.
    double surface_speed(double inverse_mass) const {
        return inverse_mass > 0.0 ? radius * spin : 0.0;
    }
};

/// The parameters of Coulomb's law at one contact.
struct Friction {
    double coefficient = 0.0;  ///< mu >= 0
    double inertia = 0.5;      ///< moment of inertia / (m r^2) of every ball: Model::spin
};

/// Applies friction between two balls that have just exchanged the normal impulse `normal_impulse`
/// >= 0. `normal` points from b to a.
///
/// The contact points slip along t = perpendicular(normal) at
///     u = (v_a - v_b) . t - (r_a w_a + r_b w_b).
/// With I = inertia m r^2 the impulse -u / ((1/m_a + 1/m_b) (1 + 1/inertia)) along t stops the
/// slip. Friction is that impulse, limited to coefficient * normal_impulse either way: the points
/// stick, or keep slipping. It never reverses the slip, so energy never grows; momentum and angular
/// momentum are conserved. Returns the impulse on a along t.
///
/// Inverse mass 0: an immovable body, which does not turn either, whatever its spin. Both 0:
/// nothing happens.
/// Source: Coulomb's law in impulses, as in Walton's model of rough spheres without tangential
/// restitution (Walton and Braun, J. Rheology 30 (1986) 949; Foerster et al., Phys. Fluids 6 (1994)
/// 1108).
inline double apply_friction(Vec2& velocity_a, Rotation a, double inverse_mass_a, Vec2& velocity_b,
                             Rotation b, double inverse_mass_b, Vec2 normal, double normal_impulse,
                             Friction friction) {
    const double inverse = inverse_mass_a + inverse_mass_b;
    if (!(inverse > 0.0)) return 0.0;
    const Vec2 along = perpendicular(normal);
    const double slip = dot(velocity_a - velocity_b, along) -
                        (a.surface_speed(inverse_mass_a) + b.surface_speed(inverse_mass_b));
    const double most = friction.coefficient * std::max(0.0, normal_impulse);
    const double stopping = -slip / (inverse * (1.0 + 1.0 / friction.inertia));
    const double impulse = std::clamp(stopping, -most, most);
    velocity_a += along * (impulse * inverse_mass_a);
    velocity_b -= along * (impulse * inverse_mass_b);
    a.spin -= impulse * inverse_mass_a / (friction.inertia * a.radius);
    b.spin -= impulse * inverse_mass_b / (friction.inertia * b.radius);
    return impulse;
}

/// Applies friction between a ball and an immovable body whose surface moves at `surface`,
/// length/s; that is 0 unless the body is kinematic. Then friction may speed the ball up, but never
/// beyond the surface.
inline double apply_friction_on_surface(Vec2& velocity, Rotation rotation, double inverse_mass,
                                        Vec2 normal, Vec2 surface, double normal_impulse,
                                        Friction friction) {
    Vec2 moved = surface;
    double still = 0.0;
    return apply_friction(velocity, rotation, inverse_mass, moved, {still, 1.0}, 0.0, normal,
                          normal_impulse, friction);
}

/// Coefficient of friction between balls of two kinds.
inline double friction_between(const Kind& a, const Kind& b) {
    return std::sqrt(a.friction * b.friction);
}

/// Restitution of a ball and an edge of this material at this approach speed, length/s.
inline double restitution_at(const Material& material, double approach) {
    return material.restitution / (1.0 + material.soften * approach);
}

/// The speed along the normal that a kicking edge adds to the bounce, length/s. `approach` is the
/// approach speed; `point` is where the ball touches, or its centre.
inline double kick_at(const Material& material, const Capsule& shape, Vec2 point, double approach) {
    if (!(material.kick > 0.0) || approach < material.kick_from) return 0.0;
    if (!material.kicks_in_the_middle) return material.kick;
    const double along = closest_parameter(shape.start, shape.end, point);
    return material.kick * 4.0 * along * (1.0 - along);
}

/// The normal of ball `id`'s edge contact number `contact`, turned by a random angle that depends
/// on the seed and these two alone. A draw that would send the ball into the edge is repeated, at
/// most 16 times; after that the normal stays. `restitution` as in the bounce that follows.
Vec2 scattered_normal(const World& world, BallId id, std::uint32_t contact, Vec2 normal,
                      Vec2 velocity, double restitution);

/// Whether an edge is solid for a ball whose centre is at `center`. A centre exactly on the spine
/// of a one-way edge is not on its solid side: a ball from behind passes.
inline bool is_on_solid_side(const Capsule& capsule, Side side, Vec2 center) {
    if (side == Side::both) return true;
    if (side == Side::none) return false;
    const double left = cross(capsule.end - capsule.start, center - capsule.start);
    return side == Side::left ? left > 0.0 : left < 0.0;
}

}  // namespace carom
