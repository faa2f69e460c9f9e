#pragma once

#include <algorithm>

#include "physics/contact/constraints.h"

// What a change of impulse does to the bodies of a constraint, for the files that iterate.
namespace carom {

template <bool spin>
inline void ContactConstraints::change_impulse(ContactConstraint& constraint, double impulse) {
    ContactBody& a = bodies_.body[constraint.a];
    ContactBody& b = bodies_.body[constraint.b];
    Vec2 velocity_a = a.velocity;
    Vec2 velocity_b = b.velocity;
    const Vec2 push = constraint.normal * (impulse - constraint.impulse);
    constraint.impulse = impulse;
    velocity_a += push * a.inverse_mass;
    velocity_b -= push * b.inverse_mass;
    if constexpr (spin) {
        const Vec2 tangent = perpendicular(constraint.normal);
        const double slip =
            dot(velocity_a - velocity_b, tangent) - (a.surface_speed + b.surface_speed);
        const double most = constraint.friction * impulse;
        const double wanted =
            constraint.tangential_impulse - slip * constraint.mass * step_.friction_mass;
        const double bounded = std::max(std::min(wanted, most), -most);
        const double change = bounded - constraint.tangential_impulse;
        constraint.tangential_impulse = bounded;
        const double of_a = change * a.inverse_mass;
        const double of_b = change * b.inverse_mass;
        velocity_a += tangent * of_a;
        velocity_b -= tangent * of_b;
        a.surface_speed -= of_a * step_.spin_ease;
        if (constraint.b != bodies_.fixed) b.surface_speed -= of_b * step_.spin_ease;
    }
    a.velocity = velocity_a;
    // Writing to the fixed body would make all pairs that share it wait for one another.
    if (constraint.b != bodies_.fixed) b.velocity = velocity_b;
}

inline double ContactConstraints::separating_speed(const ContactConstraint& constraint) const {
    return dot(bodies_.body[constraint.a].velocity - bodies_.body[constraint.b].velocity,
               constraint.normal);
}

}  // namespace carom
