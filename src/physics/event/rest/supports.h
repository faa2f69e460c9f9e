#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "physics/event/motion/ball_table.h"
#include "physics/event/motion/scene.h"
#include "physics/event/motion/spatial_index.h"
#include "physics/event/motion/trajectories.h"

namespace carom {

/// Something that a ball touches without an impact: a fixed edge or a ball. No kinematic edge is
/// one: a ball on it hops (driven_lift_height in laws/bounce.h, moving_rest_height on a seesaw), or
/// belongs to a hybrid step.
template <typename Real>
struct Support {
    Vector<Real> normal;  ///< from it to the ball, unit
    Vector<Real> center;  ///< of a round end or of a ball
    bool is_side = false;
    bool bears_weight = false;  ///< gravity presses the ball on it; else it may bar the way
    SupportId id;
};

/// The contacts that support a ball which is about to slide, turn or rest.
/// The order of the results does not depend on the cells.
template <typename Real>
class Supports {
  public:
    Supports(const EventScene<Real>& scene, const BallTable<Real>& balls,
             const SpatialIndex<Real>& space, const Trajectories<Real>& trajectories)
        : scene_(scene), balls_(balls), space_(space), trajectories_(trajectories) {}

    /// All supports of a ball whose trajectory starts now: sides that bear weight, then round ends
    /// and balls that bear weight, then barriers. A support counts if the ball is within
    /// `contact_slop` of it and would not rise above `rest_height` from it. Only resting balls
    /// count; with `also_moving` also others, within four times `moving_rest_height`.
    /// Valid until the next call.
    const std::vector<Support<Real>>& of(std::uint32_t ball, bool also_moving);

    /// The first edge found that the ball touches and that would stop it, if it moved at `velocity`
    /// with this `acceleration`; none if there is none.
    std::optional<Support<Real>> barrier_to(std::uint32_t ball, const Vector<Real>& velocity,
                                            const Vector<Real>& acceleration) const;

  private:
    void add(const LinearPart<Real>& line, const Real& size, Support<Real>& support,
             std::vector<Support<Real>>& bearing);
    void add_edge(const LinearPart<Real>& line, const Real& size, const Real& near,
                  std::uint32_t capsule, Vec2 shift, SupportId id);
    void add_ball(const LinearPart<Real>& line, const Real& size, const Real& near,
                  std::uint32_t other, SupportId id);

    const EventScene<Real>& scene_;
    const BallTable<Real>& balls_;
    const SpatialIndex<Real>& space_;
    const Trajectories<Real>& trajectories_;
    std::vector<Support<Real>> sides_;
    std::vector<Support<Real>> points_;
    std::vector<Support<Real>> bars_;
};

}  // namespace carom
