#pragma once

#include <algorithm>

#include "physics/contact/solver.h"

// What an impulse that changes does to its bodies, for the files that go over pressed pairs.
namespace carom {

template <bool spin>
inline void ContactSolver::exchange(Press& press, double impulse) {
    Mover& a = mover_[press.a];
    Mover& b = mover_[press.b];
    Vec2 velocity_a = a.velocity;
    Vec2 velocity_b = b.velocity;
    const Vec2 push = press.normal * (impulse - press.impulse);
    press.impulse = impulse;
    velocity_a += push * a.inverse_mass;
    velocity_b -= push * b.inverse_mass;
    if constexpr (spin) {
        const Vec2 along = perpendicular(press.normal);
        const double slip = dot(velocity_a - velocity_b, along) - (a.rim + b.rim);
        const double most = press.friction * impulse;
        const double wanted = press.rub - slip * press.mass * spin_mass_;
        const double whole = std::max(std::min(wanted, most), -most);
        const double part = whole - press.rub;
        press.rub = whole;
        const double of_a = part * a.inverse_mass;
        const double of_b = part * b.inverse_mass;
        velocity_a += along * of_a;
        velocity_b -= along * of_b;
        a.rim -= of_a * spin_ease_;
        if (press.b != still_) b.rim -= of_b * spin_ease_;
    }
    a.velocity = velocity_a;
    // What nothing moves would only make pairs wait for one another.
    if (press.b != still_) b.velocity = velocity_b;
}

// The speed at which the two part.
inline double ContactSolver::apart(const Press& press) const {
    return dot(mover_[press.a].velocity - mover_[press.b].velocity, press.normal);
}

}  // namespace carom
