#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/vec2.h"
#include "physics/laws/bounce.h"

/// Friction at a contact of balls on cloth: `apply_friction` of bounce.h, extended to rotation
/// about horizontal axes.
namespace carom {

/// The rotation of a ball about all three axes: side spin, rad/s, counter-clockwise seen from
/// above; roll (cloth.h), length/s; and the radius.
struct Roller {
    double& spin;
    Vec2& roll;
    double radius;

    /// Speeds of its surface, length/s: as Rotation::surface_speed.
    double surface_speed(double inverse_mass) const {
        return inverse_mass > 0.0 ? radius * spin : 0.0;
    }
    Vec2 surface_roll(double inverse_mass) const { return inverse_mass > 0.0 ? roll : Vec2{}; }
};

/// Applies friction between two balls on cloth that have just exchanged `normal_impulse` >= 0.
/// `normal` points from b to a.
///
/// The contact points slip along t = perpendicular(normal) and upwards at
///     u_t = (v_a - v_b) . t - (r_a w_a + r_b w_b)      u_z = (roll_a + roll_b) . normal.
/// The impulses that would stop both are -u_t m_t and -u_z m_z with
///     1/m_t = (1/m_a + 1/m_b) (1 + 1/inertia)          1/m_z = (1/m_a + 1/m_b) / inertia;
/// The second turns the balls without lifting them, since the table supports them. If both together
/// exceed coefficient * normal_impulse, both are scaled down to it, and the points keep slipping;
/// else they stick. Energy never grows. Returns the impulse on a along t.
///
/// Inverse mass 0: an immovable body, which does not turn either, whatever its spin and roll. Both
/// 0: nothing happens.
/// Source: Coulomb's law in impulses, as `apply_friction`; D. Alciatore, technical proofs A.14
/// (throw) and B.2.
inline double apply_cloth_friction(Vec2& velocity_a, Roller a, double inverse_mass_a,
                                   Vec2& velocity_b, Roller b, double inverse_mass_b, Vec2 normal,
                                   double normal_impulse, Friction friction) {
    const double inverse = inverse_mass_a + inverse_mass_b;
    if (!(inverse > 0.0)) return 0.0;
    const Vec2 along = perpendicular(normal);
    const double slip = dot(velocity_a - velocity_b, along) -
                        (a.surface_speed(inverse_mass_a) + b.surface_speed(inverse_mass_b));
    const double rise =
        dot(a.surface_roll(inverse_mass_a) + b.surface_roll(inverse_mass_b), normal);
    double across = -slip / (inverse * (1.0 + 1.0 / friction.inertia));
    double upwards = -rise * friction.inertia / inverse;
    const double most = friction.coefficient * std::max(0.0, normal_impulse);
    const double stopping = std::sqrt(across * across + upwards * upwards);
    if (stopping > most) {
        across *= most / stopping;
        upwards *= most / stopping;
    }
    velocity_a += along * (across * inverse_mass_a);
    velocity_b -= along * (across * inverse_mass_b);
    a.spin -= across * inverse_mass_a / (friction.inertia * a.radius);
    b.spin -= across * inverse_mass_b / (friction.inertia * b.radius);
    a.roll += normal * (upwards * inverse_mass_a / friction.inertia);
    b.roll += normal * (upwards * inverse_mass_b / friction.inertia);
    return across;
}

/// Friction between a ball on cloth and an edge whose surface moves at `surface`, length/s.
inline double apply_cloth_friction_on_edge(Vec2& velocity, Roller ball, double inverse_mass,
                                           Vec2 normal, Vec2 surface, double normal_impulse,
                                           Friction friction) {
    Vec2 moved = surface;
    Vec2 no_roll;
    double no_spin = 0.0;
    return apply_cloth_friction(velocity, ball, inverse_mass, moved, {no_spin, no_roll, 1.0}, 0.0,
                                normal, normal_impulse, friction);
}

/// The rotation of ball `i`, in a world with cloth.
inline Roller roller(Balls& balls, std::size_t i) {
    return {balls.spin[i], balls.roll[i], balls.radius[i]};
}

}  // namespace carom
