#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/event/impact/impact_cluster.h"
#include "physics/event/rest/side_friction.h"

namespace carom {

/// Friction in an impact: once the normal impulses are known, each contact passes along itself the
/// impulse that stops its slip, but no more than its coefficient times its normal impulse.
///
/// Where bodies have several such contacts, all impulses are found together, in at most
/// `most_friction_rounds`. In each round every contact sees the same velocities and takes its
/// bodies to be as heavy as their share (mass over number of contacts), so no round makes energy,
/// and the order of contacts does not show. On cloth, slip is also along the vertical, against the
/// roll; the limit then holds for the length of both impulses.
///
/// Sources: Tonge, Benevolenski and Voroshilov, Mass splitting for jitter-free parallel rigid body
/// simulation, ACM Transactions on Graphics 31, 2012; cloth: laws/cloth_contact.h.
template <typename Real>
class ImpactFriction {
  public:
    ImpactFriction(const EventScene<Real>& scene, ImpactCluster<Real>& cluster,
                   const SideFriction<Real>& friction)
        : scene_(scene), cluster_(cluster), friction_(friction) {}

    /// Changes velocities, spins and rolls of the cluster's bodies. `which`: contact points by
    /// index; `passed`: their normal impulses. Pre: Model::spin.
    void apply(const std::vector<std::uint32_t>& which, std::span<const Real> passed);

  private:
    /// A contact that passes friction, and what it has passed, mass length/s.
    struct Contact {
        const ContactPoint<Real>* point = nullptr;
        Real most{};
        Real impulse{};
        Real change{};
        Real lift{};  ///< the vertical impulse, on cloth
        Real lift_change{};
    };
    /// The slip of a contact, and its inverse effective mass with split bodies.
    struct Slip {
        Real along{};
        Real upwards{};
        Real inverse_mass{};
        Real of_seesaw{};  ///< what a seesaw adds, which does not roll
    };

    void collect(const std::vector<std::uint32_t>& which, std::span<const Real> passed);
    Slip slip_of(const Contact& each) const;
    bool solve(Contact& each, const Real& inertia) const;
    bool solve_on_cloth(Contact& each, const Real& inertia) const;
    void pass(const Contact& each, const Real& inertia);
    void pass_on_cloth(const Contact& each, const Real& inertia);

    const EventScene<Real>& scene_;
    ImpactCluster<Real>& cluster_;
    const SideFriction<Real>& friction_;
    std::vector<Contact> contacts_;
    std::vector<int> shares_;  ///< by body: its number of contacts
};

}  // namespace carom
