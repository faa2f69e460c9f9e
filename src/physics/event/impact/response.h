#pragma once

#include <cstdint>
#include <vector>

#include "physics/event/impact/impact_cluster.h"
#include "physics/event/impact/impact_group.h"
#include "physics/event/impact/position_correction.h"
#include "physics/event/motion/kinematic_bodies.h"
#include "physics/event/motion/work_meter.h"
#include "physics/event/rest/collapse_guard.h"
#include "physics/event/rest/resting_contact.h"
#include "physics/world/contact.h"

namespace carom {

/// What a tick reports about its impacts.
struct ImpactRecord {
    std::vector<Contact>& contacts;      ///< impulses, bodies by index
    std::vector<std::uint8_t>& touched;  ///< by ball: whether an impact changed it
};

/// Resolves an impact: computes its impulses, and starts new trajectories for all balls that it
/// changes.
///
///   cluster: the two bodies of the event, and all that they touch
///   repeat
///       approaching := contact points that approach faster than rounding and resting allow
///       if there are none: leave the loop
///       apply simultaneous impulses, friction and kicks (impact_group.h)
///       add to the cluster what the changed bodies touch
///   if kinematic bodies squeeze a ball (squeeze.h): stop them, and start again from the event
///   separate balls that overlap (position_correction.h)
///   start the trajectories, count the collisions, settle, freeze what the collapse guard says
///
/// Balls are *jammed* if half of the rounds do not suffice (`most_impact_rounds`, and some for each
/// contact point). From then on contacts have no restitution, and frozen balls do not give way.
/// When all rounds are used up, the remaining approaches are left as they are.
///
/// Momentum is conserved except by kinematic bodies, fixed edges, and two kinds of balls that count
/// as immovable: a resting ball on which another comes to rest (it does not wake), and a frozen
/// ball that a jammed ball hits. README.md lists where energy is lost.
template <typename Real>
class Response {
  public:
    struct Parts {
        const EventScene<Real>& scene;
        BallTable<Real>& balls;
        SpatialIndex<Real>& space;
        Trajectories<Real>& trajectories;
        KinematicBodies<Real>& kinematic;
        ImpactCluster<Real>& cluster;
        RestingContact<Real>& rest;
        const SideFriction<Real>& friction;
        CollapseGuard<Real>& guard;
        WorkMeter<Real>& work;
        std::vector<std::uint32_t>& scatter_counts;
    };
    explicit Response(const Parts& parts);

    /// Resolves the impact `event` of `ball`, now. Returns the balls whose trajectories changed,
    /// ascending; valid until the next call. The caller predicts them, and `ball` in any case. The
    /// cluster stays open for these predictions, until the caller ends it.
    const std::vector<std::uint32_t>& resolve(std::uint32_t ball, const BallEvent<Real>& event,
                                              const ImpactRecord& record);

  private:
    bool run_rounds(std::vector<Contact>& contacts);
    void hold_frozen();
    void start_trajectories(std::vector<std::uint8_t>& touched);
    void note_sunk();

    const EventScene<Real>& scene_;
    BallTable<Real>& balls_;
    SpatialIndex<Real>& space_;
    Trajectories<Real>& trajectories_;
    KinematicBodies<Real>& kinematic_;
    ImpactCluster<Real>& cluster_;
    RestingContact<Real>& rest_;
    CollapseGuard<Real>& guard_;
    WorkMeter<Real>& work_;
    ImpactGroup<Real> group_;
    PositionCorrection<Real> correction_;
    std::vector<std::uint32_t> changed_;
};

}  // namespace carom
