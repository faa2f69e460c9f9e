#pragma once

#include "physics/event/impact/impact_cluster.h"

namespace carom {

/// Separates balls that are pressed together and overlap, at the end of an impact.
///
/// Moving balls sink in by up to `moving_rest_height` (on cloth `cloth_rest_height`) before they
/// meet again. Deeper pairs are separated to touch, in proportion to their inverse masses, by at
/// most half the smaller radius. A ball that an edge or a third ball bars stays, so such pairs sink
/// in further; so do held, resting, sliding and turning balls. Separation lifts balls, which gains
/// at most the energy of that height. Nothing happens where neither gravity with losses nor cloth
/// presses balls.
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
