#pragma once

#include "physics/event/impact/impact_cluster.h"

namespace carom {

/// Separates balls that are pressed together and overlap, at the end of an impact.
///
/// Moving balls may sink into one another by about `moving_rest_height` (on cloth
/// `cloth_rest_height`) before they meet again. Pairs that are deeper are separated until they
/// touch, in proportion to their inverse masses, by at most half the smaller radius. Lifting balls
/// against gravity gains at most the energy of that displacement.
///
/// Not moved: a ball that would enter an edge or a third ball; held, resting, sliding and turning
/// balls. Pairs of these sink in further. Nothing happens in scenes where neither gravity with
/// losses nor cloth presses balls together.
template <typename Real>
class PositionCorrection {
  public:
    PositionCorrection(const EventScene<Real>& scene, const BallTable<Real>& balls,
                       const SpatialIndex<Real>& space, ImpactCluster<Real>& cluster)
        : scene_(scene), balls_(balls), space_(space), cluster_(cluster) {}

    /// Moves bodies of the cluster, which sets their `is_moved`.
    void apply();

  private:
    void move_out_of(const ContactPoint<Real>& point);
    bool enters_ball(const ClusterBody<Real>& body, const Vector<Real>& displacement) const;
    Real share_of(std::uint32_t body, const Vector<Real>& displacement) const;

    const EventScene<Real>& scene_;
    const BallTable<Real>& balls_;
    const SpatialIndex<Real>& space_;
    ImpactCluster<Real>& cluster_;
};

}  // namespace carom
