#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "physics/event/motion/ball_table.h"
#include "physics/event/motion/edge_impact.h"
#include "physics/event/motion/scene.h"
#include "physics/event/motion/trajectories.h"
#include "physics/tick/kinematic.h"

namespace carom {

/// An edge that a player, a flipper or a mover moves, or that of a seesaw.
template <typename Real>
struct KinematicEdge {
    static constexpr std::uint32_t no_seesaw = 0xffffffffu;
    std::uint32_t capsule = 0;
    bool is_driven = false;   ///< HeldCapsule::is_driven: its surface throws (driven_restitution)
    bool is_stopped = false;  ///< within the tick: it is where it was then
    MovingEdge<Real> edge;
    std::uint32_t seesaw = no_seesaw;  ///< index into World::seesaws
    bool is_standing = false;          ///< the seesaw: time stands still for it

    /// Whether balls turn it: the edge of a seesaw for which time stands still is an obstacle.
    bool is_seesaw() const { return seesaw != no_seesaw && !is_standing; }
};

/// The kinematic bodies of the solver `event`: balls and edges that something outside of the
/// physics moves. Each moves uniformly to its target during the tick, and nothing pushes it. When
/// one of them squeezes a ball, all of them stop for the rest of the tick (impact/squeeze.h).
///
/// The edges of seesaws are listed with them, but balls push them (`turn`), and they do not stop
/// when something is squeezed. Each turns at a constant rate, exactly on its arc, until an impact
/// or a stop changes the rate.
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

    /// The seesaw of an edge, as it was at the time of that edge (MovingEdge::time). Pre: it is
    /// one.
    const Seesaw& seesaw_of(const KinematicEdge<Real>& edge) const { return seesaws_[edge.seesaw]; }
    /// The seesaw at `when`, if nothing hits it before.
    Seesaw seesaw_at(const KinematicEdge<Real>& edge, const Real& when) const;
    /// An impact has given the seesaw of edge `index` this rate, now. Every prediction is outdated.
    void turn(std::uint32_t index, double rate);
    /// When the first seesaw comes to a stop, s; infinite if none does.
    const Real& next_stop() const { return next_stop_; }
    /// The seesaws that come to their stops now bounce. Every prediction is outdated.
    void bounce_at_stops();

    /// Stops all but seesaws now. Trajectories of other balls stay, but every prediction is
    /// outdated: see `take_stopped`. Returns whether any of them was moving.
    bool stop();
    /// Whether something has stopped, or a seesaw has changed its rate, since the last call.
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
    void set_motion(KinematicEdge<Real>& edge, const Seesaw& seesaw);
    void find_next_stop();

    std::vector<Seesaw> seesaws_;  ///< by World::seesaws, each at the time of its edge
    Real next_stop_{std::numeric_limits<double>::infinity()};
    std::vector<HeldEdge> held_;  ///< scratch
    bool has_stopped_ = false;
};

}  // namespace carom
