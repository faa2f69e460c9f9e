#pragma once

#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

#include "geometry/vector.h"

/// Simultaneous impacts: the impulses of contacts at the same instant.
///
/// Rule: all approaching contacts are reflected at once. Find the impulses, none of which pulls,
/// that stop every approach with the least change in kinetic energy; apply 1 + restitution times
/// them. If contacts approach afterwards, reflect those, and so on until none does. Contacts that
/// touch without approaching take no part in a step.
///
/// Reasons: the rule conserves momentum, and energy with restitution 1; it only pushes; it respects
/// symmetry, so neither the order of a file nor the ids of balls matter; and a shock runs through a
/// row of touching balls one by one, as through a row with gaps. Source: Smith, Kaufman, Vouga,
/// Tamstorf, Grinspun, Reflections on simultaneous impact, ACM Transactions on Graphics 31 (2012),
/// where it is called generalised reflections.
namespace carom {

/// A ball, or an edge on a hinge (world/seesaw.h), whose velocity is (rate, 0) in rad/s, and whose
/// inverse mass is that of its moment of inertia.
template <typename Real>
struct ImpactBody {
    Vector<Real> velocity;
    Real inverse_mass{};  ///< 0: immovable
};

template <typename Real>
struct ImpactContact {
    static constexpr std::uint32_t fixed = 0xffffffffu;
    std::uint32_t a = 0;      ///< index of a body
    std::uint32_t b = fixed;  ///< index of a body, or `fixed`: an edge
    Vector<Real> normal;      ///< unit, from b to a
    Real surface{};           ///< of the edge: its velocity along the normal, length/s
    Real restitution{1.0};
    /// b is on a hinge: then `surface` is the lever arm with which the normal turns it,
    /// cross(point - pivot, normal), length.
    bool is_hinged = false;

    /// The direction in which b feels the impulse.
    Vector<Real> normal_of_b() const { return is_hinged ? Vector<Real>{surface, Real{}} : normal; }
    const Real& lever() const { return surface; }  ///< Pre: is_hinged
};

/// Approach speed at the contact, length/s; negative if the bodies separate.
template <typename Real>
Real approach_of(const ImpactContact<Real>& contact, std::span<const ImpactBody<Real>> bodies) {
    const Real ours = dot(bodies[contact.a].velocity, contact.normal);
    if (contact.b == ImpactContact<Real>::fixed) return contact.surface - ours;
    return dot(bodies[contact.b].velocity, contact.normal_of_b()) - ours;
}

/// One step of the rule: changes the velocities of `bodies`, and returns the impulse of each
/// contact, >= 0. Contacts connected through movable bodies all take the smallest restitution among
/// them. A contact that does not approach passes an impulse only if those of others make it
/// approach. Memory, also for the result, comes from `memory`. Pre: at least one body of each
/// contact is movable.
template <typename Real>
std::pmr::vector<Real> reflect(
    std::span<ImpactBody<Real>> bodies, std::span<const ImpactContact<Real>> contacts,
    std::pmr::memory_resource* memory = std::pmr::get_default_resource());

/// Applies an impulse at the contact to its bodies.
template <typename Real>
void push(std::span<ImpactBody<Real>> bodies, const ImpactContact<Real>& contact,
          const Real& impulse) {
    const Vector<Real> momentum = contact.normal * impulse;
    bodies[contact.a].velocity += momentum * bodies[contact.a].inverse_mass;
    if (contact.b != ImpactContact<Real>::fixed)
        bodies[contact.b].velocity -=
            contact.normal_of_b() * impulse * bodies[contact.b].inverse_mass;
}

/// `reflect` for a single contact, which approaches: returns its impulse.
template <typename Real>
Real reflect_alone(std::span<ImpactBody<Real>> bodies, const ImpactContact<Real>& contact) {
    Real yielding = length_squared(contact.normal) * bodies[contact.a].inverse_mass;
    if (contact.b != ImpactContact<Real>::fixed)
        yielding += length_squared(contact.normal_of_b()) * bodies[contact.b].inverse_mass;
    const Real impulse =
        (Real(1.0) + contact.restitution) * approach_of<Real>(contact, bodies) / yielding;
    push<Real>(bodies, contact, impulse);
    return impulse;
}

}  // namespace carom
