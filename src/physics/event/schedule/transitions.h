#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "physics/event/motion/spatial_index.h"
#include "physics/event/motion/trajectories.h"
#include "physics/event/rest/cloth_phases.h"
#include "physics/event/rest/collapse_guard.h"
#include "physics/event/rest/resting_contact.h"
#include "physics/event/rest/side_friction.h"

namespace carom {

/// Events in which a ball's motion changes without an impact:
///
///   sliding    reaches the end of its side, or its slip ends
///   turning    its piece ends, it turns back, nothing presses it on any more, or a side begins
///   resting    its spin has been braked; a frozen ball thaws
///   slipping, rolling on cloth    the phase ends
///
/// Other motions have none.
template <typename Real>
class Transitions {
  public:
    Transitions(const EventScene<Real>& scene, BallTable<Real>& balls,
                const SpatialIndex<Real>& space, Trajectories<Real>& trajectories,
                SideFriction<Real>& friction, RestingContact<Real>& rest, ClothPhases<Real>& cloth,
                CollapseGuard<Real>& guard, ToiSearch<Real>& search)
        : scene_(scene),
          balls_(balls),
          space_(space),
          trajectories_(trajectories),
          friction_(friction),
          rest_(rest),
          cloth_(cloth),
          guard_(guard),
          search_(search) {}

    /// Sets `best` to the ball's next transition if that comes before it.
    void predict(std::uint32_t ball, BallEvent<Real>& best);

    /// Performs the transition now. Returns the balls whose trajectories changed, this one first;
    /// the caller predicts them. Valid until the next call.
    const std::vector<std::uint32_t>& handle(std::uint32_t ball);

    /// On a torus: starts the ball's trajectory again in the frame, with its present motion.
    void restart_in_frame(std::uint32_t ball);

  private:
    void predict_end_of_side(std::uint32_t ball, const Trajectory<Real>& trajectory,
                             BallEvent<Real>& best);
    std::optional<Real> end_of_turn(std::uint32_t ball) const;
    void release_from(std::uint32_t ball);

    const EventScene<Real>& scene_;
    BallTable<Real>& balls_;
    const SpatialIndex<Real>& space_;
    Trajectories<Real>& trajectories_;
    SideFriction<Real>& friction_;
    RestingContact<Real>& rest_;
    ClothPhases<Real>& cloth_;
    CollapseGuard<Real>& guard_;
    ToiSearch<Real>& search_;
    std::vector<std::uint32_t> changed_;
    std::vector<std::uint32_t> released_;
};

}  // namespace carom
