#pragma once

#include <cstdint>
#include <optional>

#include "physics/event/motion/trajectories.h"
#include "physics/event/rest/supports.h"
#include "physics/laws/cloth.h"

namespace carom {

/// Balls on cloth: each slips, rolls or lies still, with constant acceleration (laws/cloth.h). The
/// end of such a phase is a transition, and an impact starts another phase. Pre of all functions,
/// unless they say otherwise: Model::cloth.
///
/// Cloth presses a ball against a body towards which it turns, so it would bounce there without
/// end. At an edge, a rebound that would rise less than `rest_height` is dropped, and the ball
/// loses the part of its roll that turns it into the edge. Between balls see restitution.h.
template <typename Real>
class ClothPhases {
  public:
    ClothPhases(const EventScene<Real>& scene, BallTable<Real>& balls,
                Trajectories<Real>& trajectories, const Supports<Real>& supports)
        : scene_(scene), balls_(balls), trajectories_(trajectories), supports_(supports) {}

    /// The phase that starts with the trajectory's velocity and its roll, `center`.
    ClothPhase<Real> phase_of(const Trajectory<Real>& trajectory) const;
    /// Chooses the phase of a ball whose trajectory has just started, with its roll in `center`.
    void begin_phase(std::uint32_t ball);
    /// When the phase ends, s; none: never.
    std::optional<Real> end_of_phase(std::uint32_t ball) const;
    /// The phase ends now: a ball that slipped rolls, one that rolled lies still.
    void end_phase(std::uint32_t ball);
    /// Whether a stored trajectory belongs to the scene's cloth or, in a scene without cloth, is
    /// one without cloth.
    bool is_of_this_cloth(const Trajectory<Real>& trajectory) const;

  private:
    const EventScene<Real>& scene_;
    BallTable<Real>& balls_;
    Trajectories<Real>& trajectories_;
    const Supports<Real>& supports_;
};

}  // namespace carom
