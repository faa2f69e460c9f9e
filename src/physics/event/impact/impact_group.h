#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <vector>

#include "physics/event/impact/impact_cluster.h"
#include "physics/event/impact/impact_friction.h"
#include "physics/event/impact/lasting_impact.h"
#include "physics/event/impact/restitution.h"
#include "physics/event/motion/work_meter.h"
#include "physics/world/contact.h"

namespace carom {

/// The contact points of a cluster that approach in one round of an impact, as a group for the
/// simultaneous impact (laws/simultaneous_impact.h), and the impulses that they pass.
///
/// An approach does not count if rounding alone explains it. Where gravity presses bodies together
/// (`Field::pressing`), one that a fall through `rest_height` (between moving balls
/// `moving_rest_height`) would give does not count either, except at the contact of the event
/// itself.
///
/// A contact alone may have a normal of its own: that of a curve, or a scattered one. Where
/// contacts last (`Model::modulus`), the group is the one that lasting_impact.h finds.
///
/// A seesaw that stands at a stop does not give way towards it: the stop takes its part of the
/// impulses in the same round.
///
/// A resting ball does not wake if another one comes to rest on it: for that round it counts as
/// immovable.
template <typename Real>
class ImpactGroup {
  public:
    struct Parts {
        const EventScene<Real>& scene;
        BallTable<Real>& balls;
        const KinematicBodies<Real>& kinematic;
        ImpactCluster<Real>& cluster;
        const SideFriction<Real>& friction;
        WorkMeter<Real>& work;
        std::vector<std::uint32_t>& scatter_counts;
    };
    explicit ImpactGroup(const Parts& parts);

    /// Begins an impact. `counts_loss`: lost() is wanted.
    void begin(bool counts_loss);
    /// Finds the contact points that approach, and returns how many there are.
    std::size_t find(bool is_first_round);
    /// Passes the impulses of this round between the bodies of the cluster, with friction and
    /// kicks, and appends a contact for each. Pre: find() has returned at least 1.
    void pass_impulses(bool is_first_round, std::vector<Contact>& contacts);
    /// All contact points of the cluster that can give way pass impulses without restitution.
    void stop_all();

    /// Kinetic energy that the normal impulses have taken since begin(), mass length^2/s^2.
    const Real& lost() const { return lost_; }

  private:
    /// The inverse masses of a soft impact, of which a resting ball may lack its own.
    struct Masses {
        Real a{};
        Real b{};
    };

    Real least_approach_of(const ContactPoint<Real>& point, bool is_of_event) const;
    Real least_turn_of(const ContactPoint<Real>& point) const;
    Real pressing_speed(const ContactPoint<Real>& point) const;
    void add_stops();
    std::size_t count_without_stops() const;
    void hold_at_stop(std::size_t at);
    void prepare(bool is_alone);
    bool follow_curve(const ContactPoint<Real>& point);
    bool press();
    bool is_soft() const;
    Masses hold_resting();
    void note_loss();
    void note_changes(bool is_soft, std::vector<Contact>& contacts);
    void record_contact(std::size_t at, std::vector<Contact>& contacts);

    const EventScene<Real>& scene_;
    BallTable<Real>& balls_;
    ImpactCluster<Real>& cluster_;
    WorkMeter<Real>& work_;
    std::vector<std::uint32_t>& scatter_counts_;
    Restitution<Real> restitution_;
    LastingImpact<Real> lasting_;
    ImpactFriction<Real> friction_;
    std::vector<std::uint32_t> approaching_;  ///< contact points by index
    std::vector<ImpactContact<Real>> group_;  ///< those
    std::vector<Real> approach_;              ///< speed at each of group_, length/s
    std::pmr::unsynchronized_pool_resource memory_{{.largest_required_pool_block = 1 << 20}};
    std::pmr::vector<Real> passed_{&memory_};  ///< normal impulse of each
    Real lost_{};
    bool counts_loss_ = false;
    bool rolls_on_ = false;  ///< the group is one ball that rolls on along a curve
};

}  // namespace carom
