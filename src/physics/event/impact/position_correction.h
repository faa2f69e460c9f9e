#pragma once

#include <cstdint>
#include <vector>

#include "physics/event/impact/impact_cluster.h"

namespace carom {

/// Separates balls that are pressed together and overlap, at the end of an impact.
///
/// Moving balls may sink into one another by about `moving_rest_height` (on cloth
/// `cloth_rest_height`) before they meet again. Pairs that are deeper are separated until they
/// touch, in proportion to their inverse masses, by at most half the smaller radius.
///
/// Lifting balls against gravity adds no energy. The impact has mostly taken as much out of them,
/// since they have fallen into one another as far as they are lifted. What is missing comes out of
/// their velocities: all bodies of the cluster become slower by the same share, relative to their
/// centre of mass if nothing else touches them. If they are too slow for that, they are lifted
/// less.
///
/// A ball that an edge bars goes along the edge instead, as far as the normal leads that way. So
/// a ball that leans on a wall still separates from one on the floor, impact by impact, instead of
/// sinking in: the one goes up the wall, the other along the floor.
///
/// Not moved: a ball that two edges bar, or that would enter a third ball; held and resting balls.
/// Pairs of these sink in further. Nothing happens in scenes where neither gravity with losses nor
/// cloth presses balls together.
template <typename Real>
class PositionCorrection {
  public:
    PositionCorrection(const EventScene<Real>& scene, const BallTable<Real>& balls,
                       const SpatialIndex<Real>& space, ImpactCluster<Real>& cluster)
        : scene_(scene), balls_(balls), space_(space), cluster_(cluster) {}

    /// Whether this scene's balls are separated, and pay for it.
    bool is_paid() const;
    /// Moves bodies of the cluster, which sets their `is_moved`, and slows them. `lost`: kinetic
    /// energy that the impact has taken out of them, mass length^2/s^2.
    void apply(const Real& lost);

  private:
    /// The place of a body before it was moved.
    struct Start {
        std::uint32_t body;
        Vector<Real> position;
    };
    /// The motion of the cluster as a whole.
    struct Momentum {
        Vector<Real> velocity;  ///< of the centre of mass, length/s; 0 if other bodies touch it
        Real kinetic{};         ///< energy relative to that, mass length^2/s^2
    };

    void separate();
    void move(std::uint32_t body, const Vector<Real>& displacement);
    void pay(const Real& lost);
    Real lifted() const;
    Momentum momentum() const;
    void move_out_of(const ContactPoint<Real>& point);
    bool enters_ball(const ClusterBody<Real>& body, const Vector<Real>& displacement) const;
    /// A displacement within the room that edges and other balls leave.
    struct Allowed {
        Vector<Real> displacement;
        Real inverse_mass{};  ///< of the body; 0: it may not move
    };
    Allowed allowed(std::uint32_t body, const Vector<Real>& displacement) const;
    bool deflect(const ClusterBody<Real>& body, Vector<Real>& displacement) const;

    const EventScene<Real>& scene_;
    const BallTable<Real>& balls_;
    const SpatialIndex<Real>& space_;
    ImpactCluster<Real>& cluster_;
    std::vector<Start> moved_;  ///< each body once
};

}  // namespace carom
