#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "physics/event/motion/trajectories.h"
#include "physics/event/rest/cloth_phases.h"
#include "physics/event/rest/side_friction.h"
#include "physics/event/rest/supports.h"

namespace carom {

/// Chooses the motion of a ball that gravity presses against something: it slides along a side,
/// turns round an end, or rests. Wakes balls whose support moves. Without gravity balls never rest.
///
/// A ball rests on edges and on resting balls. Two supports hold it if together they can bear all
/// of gravity, even if gravity presses the ball on one of them alone, along which it would slide
/// against the other. A resting ball does not press on its supports: piles stay as they came to
/// rest, and this solver does not compute how their weight is distributed.
template <typename Real>
class RestingContact {
  public:
    RestingContact(const EventScene<Real>& scene, BallTable<Real>& balls,
                   const SpatialIndex<Real>& space, Trajectories<Real>& trajectories,
                   Supports<Real>& supports, SideFriction<Real>& friction, ClothPhases<Real>& cloth)
        : scene_(scene),
          balls_(balls),
          space_(space),
          trajectories_(trajectories),
          supports_(supports),
          friction_(friction),
          cloth_(cloth) {}

    /// Chooses the motion of a ball whose free flight has just started: by its supports, on cloth
    /// by its phase. It stays in free flight where nothing supports it.
    void settle(std::uint32_t ball);

    /// Whether two of the ball's present supports hold it, moving balls included.
    bool is_held_up(std::uint32_t ball) {
        return bearing_two(supports_.of(ball, true)).has_value();
    }

    /// The ball has left its place: starts free flight for what it supported, and for what that
    /// supported if it rested. Appends those balls to `released`. The caller settles and predicts
    /// them.
    void release_supported(std::uint32_t ball, std::vector<std::uint32_t>& released);

  private:
    bool is_barred(const Support<Real>& support, const Support<Real>& other) const;
    bool leads_against(std::uint32_t ball, const Support<Real>& support,
                       const Support<Real>& other) const;
    std::optional<std::pair<std::size_t, std::size_t>> bearing_two(
        const std::vector<Support<Real>>& supports) const;
    void rest_on_two(std::uint32_t ball, const Support<Real>& first, const Support<Real>& second);
    void rest_on_one(std::uint32_t ball, const Support<Real>& support);

    const EventScene<Real>& scene_;
    BallTable<Real>& balls_;
    const SpatialIndex<Real>& space_;
    Trajectories<Real>& trajectories_;
    Supports<Real>& supports_;
    SideFriction<Real>& friction_;
    ClothPhases<Real>& cloth_;
    std::vector<std::uint32_t> moved_;  ///< supports whose load is still to be released
};

}  // namespace carom
