#pragma once

#include <cstdint>
#include <vector>

#include "physics/event/motion/ball_table.h"
#include "physics/event/motion/edge_impact.h"
#include "physics/event/motion/scene.h"
#include "physics/event/motion/trajectories.h"
#include "physics/tick/kinematic.h"

namespace carom {

/// An edge that a player or a solenoid moves.
template <typename Real>
struct KinematicEdge {
    std::uint32_t capsule = 0;
    bool is_motorised = false;  ///< a solenoid drives it: its surface throws (driven_restitution)
    bool is_stopped = false;    ///< before the end of the tick, at the end of which it still moves
    MovingEdge<Real> edge;
};

/// The kinematic bodies of the solver `event`: balls and edges that something outside of the
/// physics moves. Each moves uniformly to its target during the tick, and nothing pushes it. When
/// one of them squeezes a ball, all of them stop for the rest of the tick (impact/squeeze.h).
///
/// tick/kinematic.h lists these bodies and their displacements for all solvers. Solvers with
/// substeps multiply the remaining displacement by a rate (`aim`). Here it is divided by the tick's
/// duration once, in the engine's number type, and the trajectory is absolute in time: the two
/// round differently.
template <typename Real>
class KinematicBodies {
  public:
    KinematicBodies(const EventScene<Real>& scene, BallTable<Real>& balls,
                    Trajectories<Real>& trajectories)
        : scene_(scene), balls_(balls), trajectories_(trajectories) {}

    /// Reads the world's held bodies for this tick. Held balls get inverse mass 0 and the velocity
    /// to their target; the caller starts their trajectories.
    void take();

    const std::vector<KinematicEdge<Real>>& edges() const { return edges_; }

    /// Stops all of them now. Trajectories of other balls stay, but every prediction is outdated:
    /// see `take_stopped`. Returns whether any of them was moving.
    bool stop();
    /// Whether something has stopped since the last call.
    bool take_stopped() {
        const bool stopped = has_stopped_;
        has_stopped_ = false;
        return stopped;
    }

  private:
    const EventScene<Real>& scene_;
    BallTable<Real>& balls_;
    Trajectories<Real>& trajectories_;
    std::vector<KinematicEdge<Real>> edges_;
    std::vector<HeldEdge> held_;  ///< scratch
    bool has_stopped_ = false;
};

}  // namespace carom
