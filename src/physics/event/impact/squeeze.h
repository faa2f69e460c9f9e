#pragma once

#include "physics/event/impact/impact_cluster.h"
#include "physics/event/motion/ball_table.h"

/// Detects kinematic bodies that squeeze a ball which cannot get away. Response asks both functions
/// after the impulses of an impact; all kinematic bodies must stop if `hold_back` returns false or
/// `pushes_without_end` returns true.
namespace carom {

/// Keeps every held ball of the cluster out of the edges that it touches: the ball moves along such
/// an edge; if that leads into another edge, along that one; else it stops. Returns false if an
/// edge still moves into a held ball.
template <typename Real>
bool hold_back(ImpactCluster<Real>& cluster, const BallTable<Real>& balls);

/// Whether a kinematic body touches a ball whose collisions do not end: balls of the cluster are
/// jammed (response.h), or the ball has had more than `most_recent_collisions`.
template <typename Real>
bool pushes_without_end(const ImpactCluster<Real>& cluster, const BallTable<Real>& balls,
                        bool is_jammed);

}  // namespace carom
