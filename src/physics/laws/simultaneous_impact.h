#pragma once

#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

#include "geometry/vector.h"

/// What contacts at the same instant do together.
///
/// Rule: all contacts that approach at once are reflected at once, as one wall is: the impulses are
/// those, all pushing, that would stop every approach with the least change (in kinetic energy),
/// and what is passed is 1 + restitution of them. If others approach then, these are reflected
/// next, until nothing approaches. Contacts that touch but do not approach take no part in a step.
///
/// Ground: it keeps momentum, and with restitution 1 energy; pushes only; treats alike what is
/// alike, so neither the order of a file nor the names of balls matter; and lets a shock run
/// through a row of touching balls one by one, as a row with gaps does. Source: Smith, Kaufman,
/// Vouga, Tamstorf, Grinspun, Reflections on simultaneous impact, ACM Transactions on Graphics 31
/// (2012), where it is called generalised reflections.
namespace carom {

template <typename Real>
struct ImpactBody {
    Vector<Real> velocity;
    Real inverse_mass{};  ///< 0: nothing moves it
};

template <typename Real>
struct ImpactContact {
    static constexpr std::uint32_t fixed = 0xffffffffu;
    std::uint32_t a = 0;      ///< index of a body
    std::uint32_t b = fixed;  ///< index of a body, or something that nothing moves
    Vector<Real> normal;      ///< unit, from b to a
    Real surface{};           ///< velocity along the normal of what is fixed, length/s
    Real restitution{1.0};
};

/// How fast the contact closes, length/s.
template <typename Real>
Real approach_of(const ImpactContact<Real>& contact, std::span<const ImpactBody<Real>> bodies) {
    const Real ours = dot(bodies[contact.a].velocity, contact.normal);
    if (contact.b == ImpactContact<Real>::fixed) return contact.surface - ours;
    return dot(bodies[contact.b].velocity, contact.normal) - ours;
}

/// One step of the rule for `contacts`, all of which approach: the impulse of each, >= 0. Contacts
/// that hang together take the smallest restitution among them. Changes the velocities of `bodies`.
/// What it needs comes from `memory`, the impulses too.
/// Pre: of each contact at least one body can be moved.
template <typename Real>
std::pmr::vector<Real> reflect(
    std::span<ImpactBody<Real>> bodies, std::span<const ImpactContact<Real>> contacts,
    std::pmr::memory_resource* memory = std::pmr::get_default_resource());

/// The bodies of the contact, after an impulse at it.
template <typename Real>
void push(std::span<ImpactBody<Real>> bodies, const ImpactContact<Real>& contact,
          const Real& impulse) {
    const Vector<Real> way = contact.normal * impulse;
    bodies[contact.a].velocity += way * bodies[contact.a].inverse_mass;
    if (contact.b != ImpactContact<Real>::fixed)
        bodies[contact.b].velocity -= way * bodies[contact.b].inverse_mass;
}

/// The same as `reflect` for one contact alone: its impulse.
template <typename Real>
Real reflect_alone(std::span<ImpactBody<Real>> bodies, const ImpactContact<Real>& contact) {
    const Real square = length_squared(contact.normal);
    Real yielding = square * bodies[contact.a].inverse_mass;
    if (contact.b != ImpactContact<Real>::fixed)
        yielding += square * bodies[contact.b].inverse_mass;
    const Real impulse =
        (Real(1.0) + contact.restitution) * approach_of<Real>(contact, bodies) / yielding;
    push<Real>(bodies, contact, impulse);
    return impulse;
}

}  // namespace carom
