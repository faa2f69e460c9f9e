#pragma once

#include "physics/contact/solver.h"

// What an impulse that changes does to its bodies, for the files that go over pressed pairs.
namespace carom {

template <bool spin>
inline void ContactSolver::exchange(Presses& presses, Two impulse) {
    Mover& first_a = mover_[presses.a[0]];
    Mover& second_a = mover_[presses.a[1]];
    Mover& first_b = mover_[presses.b[0]];
    Mover& second_b = mover_[presses.b[1]];
    Two ax{first_a.velocity.x, second_a.velocity.x};
    Two ay{first_a.velocity.y, second_a.velocity.y};
    Two bx{first_b.velocity.x, second_b.velocity.x};
    Two by{first_b.velocity.y, second_b.velocity.y};
    const Two inverse_a{first_a.inverse_mass, second_a.inverse_mass};
    const Two inverse_b{first_b.inverse_mass, second_b.inverse_mass};
    const Two change = impulse - presses.impulse;
    const Two push_x = presses.normal_x * change;
    const Two push_y = presses.normal_y * change;
    presses.impulse = impulse;
    ax += push_x * inverse_a;
    ay += push_y * inverse_a;
    bx -= push_x * inverse_b;
    by -= push_y * inverse_b;
    if constexpr (spin) {
        Two rim_a{first_a.rim, second_a.rim};
        Two rim_b{first_b.rim, second_b.rim};
        // Along is the perpendicular of the normal.
        const Two along_x = -presses.normal_y;
        const Two along_y = presses.normal_x;
        const Two slip = ((ax - bx) * along_x + (ay - by) * along_y) - (rim_a + rim_b);
        const Two most = presses.friction * impulse;
        const Two wanted = presses.rub - slip * presses.mass * spin_mass_;
        const Two whole = at_least(-most, at_most(most, wanted));
        const Two part = whole - presses.rub;
        presses.rub = whole;
        const Two of_a = part * inverse_a;
        const Two of_b = part * inverse_b;
        ax += along_x * of_a;
        ay += along_y * of_a;
        bx -= along_x * of_b;
        by -= along_y * of_b;
        rim_a -= of_a * spin_ease_;
        rim_b -= of_b * spin_ease_;
        first_a.rim = rim_a[0];
        if (presses.a[1] != still_) second_a.rim = rim_a[1];
        if (presses.b[0] != still_) first_b.rim = rim_b[0];
        if (presses.b[1] != still_) second_b.rim = rim_b[1];
    }
    // What nothing moves would only make pairs wait for one another.
    first_a.velocity = {ax[0], ay[0]};
    if (presses.a[1] != still_) second_a.velocity = {ax[1], ay[1]};
    if (presses.b[0] != still_) first_b.velocity = {bx[0], by[0]};
    if (presses.b[1] != still_) second_b.velocity = {bx[1], by[1]};
}

// The speed at which each two part.
inline Two ContactSolver::apart(const Presses& presses) const {
    const Vec2 first = mover_[presses.a[0]].velocity - mover_[presses.b[0]].velocity;
    const Vec2 second = mover_[presses.a[1]].velocity - mover_[presses.b[1]].velocity;
    return Two{first.x, second.x} * presses.normal_x + Two{first.y, second.y} * presses.normal_y;
}

}  // namespace carom
