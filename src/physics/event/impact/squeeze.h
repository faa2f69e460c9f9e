#pragma once

#include "physics/event/impact/impact_cluster.h"
#include "physics/event/motion/ball_table.h"

/// Kinematic bodies that squeeze a ball which cannot get away: both functions are asked after the
/// impulses of an impact have been passed, and either answer means that kinematic bodies must stop.
namespace carom {

/// Holds back every held ball of the cluster: it does not move into an edge that it touches, but
/// along it; if that leads into another edge, along that one; else it stands. False if an edge
/// moves into one even then.
template <typename Real>
bool hold_back(ImpactCluster<Real>& cluster, const BallTable<Real>& balls);

/// Whether a kinematic body touches a ball whose collisions do not end: balls of the cluster are
/// jammed (response.h), or the ball has had more than `most_recent_collisions`.
template <typename Real>
bool pushes_without_end(const ImpactCluster<Real>& cluster, const BallTable<Real>& balls,
                        bool is_jammed);

}  // namespace carom
