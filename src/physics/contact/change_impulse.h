#pragma once

#include <utility>

#include "geometry/f64x2.h"
#include "physics/contact/constraints.h"

// What a change of impulse does to the bodies of constraints, for the files that iterate: to those
// of two constraints side by side, which share no body but the fixed one.
namespace carom {

namespace contact_lanes {

/// A member of both.
template <typename Record>
inline F64x2 both(const Record& first, const Record& second, double Record::*member) {
    return F64x2{first.*member, second.*member};
}

/// The vectors of two constraints or bodies, by component.
struct Vectors {
    F64x2 x;
    F64x2 y;

    Vectors(Vec2 first, Vec2 second) : x{first.x, second.x}, y{first.y, second.y} {}
};

}  // namespace contact_lanes

template <bool spin>
inline void ContactConstraints::change_impulses(ContactPair& first, ContactPair& second,
                                                F64x2 impulse) {
    using contact_lanes::both, contact_lanes::Vectors;
    ContactBody& first_a = bodies_.body[first.a];
    ContactBody& first_b = bodies_.body[first.b];
    ContactBody& second_a = bodies_.body[second.a];
    ContactBody& second_b = bodies_.body[second.b];
    const Vectors normal(first.normal, second.normal);
    Vectors a(first_a.velocity, second_a.velocity);
    Vectors b(first_b.velocity, second_b.velocity);
    const F64x2 inverse_a = both(first_a, second_a, &ContactBody::inverse_mass);
    const F64x2 inverse_b = both(first_b, second_b, &ContactBody::inverse_mass);
    const F64x2 more = impulse - both(first, second, &ContactPair::impulse);
    const F64x2 push_x = normal.x * more;
    const F64x2 push_y = normal.y * more;
    first.impulse = impulse[0];
    second.impulse = impulse[1];
    a.x += push_x * inverse_a;
    a.y += push_y * inverse_a;
    b.x -= push_x * inverse_b;
    b.y -= push_y * inverse_b;
    // Writing to the fixed body would make all pairs that share it wait for one another.
    const bool moves_second_a = second.a != bodies_.fixed;
    const bool moves_first_b = first.b != bodies_.fixed;
    const bool moves_second_b = second.b != bodies_.fixed;
    if constexpr (spin) {
        const F64x2 tangent_x = -normal.y;
        const F64x2 tangent_y = normal.x;
        F64x2 surface_a = both(first_a, second_a, &ContactBody::surface_speed);
        F64x2 surface_b = both(first_b, second_b, &ContactBody::surface_speed);
        const F64x2 old = both(first, second, &ContactPair::tangential_impulse);
        const F64x2 slip =
            ((a.x - b.x) * tangent_x + (a.y - b.y) * tangent_y) - (surface_a + surface_b);
        const F64x2 most = both(first, second, &ContactPair::friction) * impulse;
        const F64x2 wanted =
            old - slip * both(first, second, &ContactPair::mass) * step_.friction_mass;
        const F64x2 bounded = at_least(-most, at_most(most, wanted));
        const F64x2 change = bounded - old;
        first.tangential_impulse = bounded[0];
        second.tangential_impulse = bounded[1];
        const F64x2 of_a = change * inverse_a;
        const F64x2 of_b = change * inverse_b;
        a.x += tangent_x * of_a;
        a.y += tangent_y * of_a;
        b.x -= tangent_x * of_b;
        b.y -= tangent_y * of_b;
        surface_a -= of_a * step_.spin_ease;
        surface_b -= of_b * step_.spin_ease;
        first_a.surface_speed = surface_a[0];
        if (moves_second_a) second_a.surface_speed = surface_a[1];
        if (moves_first_b) first_b.surface_speed = surface_b[0];
        if (moves_second_b) second_b.surface_speed = surface_b[1];
    }
    first_a.velocity = {a.x[0], a.y[0]};
    if (moves_second_a) second_a.velocity = {a.x[1], a.y[1]};
    if (moves_first_b) first_b.velocity = {b.x[0], b.y[0]};
    if (moves_second_b) second_b.velocity = {b.x[1], b.y[1]};
}

template <typename Visit>
inline void ContactConstraints::upwards_by_twos(Visit&& visit) {
    const std::span<const std::uint32_t> constraints = classification_.constraints();
    for (std::size_t k = 0; k < constraints.size();) {
        ContactPair& first = pairs_[constraints[k++]];
        visit(first, first.has_neighbour ? pairs_[constraints[k++]] : nothing_);
    }
}

template <typename Visit>
inline void ContactConstraints::downwards_by_twos(Visit&& visit) {
    const std::span<const std::uint32_t> constraints = classification_.constraints();
    // One call, so that it is inlined once.
    for (std::size_t k = constraints.size(); k > 0;) {
        ContactPair* first = &pairs_[constraints[--k]];
        ContactPair* second = &nothing_;
        if (k > 0 && pairs_[constraints[k - 1]].has_neighbour)
            second = std::exchange(first, &pairs_[constraints[--k]]);
        visit(*first, *second);
    }
}

inline double ContactConstraints::separating_speed(const ContactPair& constraint) const {
    return dot(bodies_.body[constraint.a].velocity - bodies_.body[constraint.b].velocity,
               constraint.normal);
}

inline F64x2 ContactConstraints::separating_speeds(const ContactPair& first,
                                                   const ContactPair& second) const {
    using contact_lanes::Vectors;
    const Vectors a(bodies_.body[first.a].velocity, bodies_.body[second.a].velocity);
    const Vectors b(bodies_.body[first.b].velocity, bodies_.body[second.b].velocity);
    const Vectors normal(first.normal, second.normal);
    return (a.x - b.x) * normal.x + (a.y - b.y) * normal.y;
}

}  // namespace carom
