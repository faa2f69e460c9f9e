#pragma once

#include <cstdint>
#include <vector>

#include "physics/event/motion/ball_table.h"
#include "physics/event/motion/scene.h"
#include "physics/event/motion/trajectories.h"

namespace carom {

// clang-format off
/// Keeps the number of events finite where collisions accumulate: inelastic collapse, jammed balls,
/// dense clusters.
///
/// Each ball counts its recent collisions (LinearPart::recent_collisions): under gravity, those in
/// quick succession (`quick_succession`), forgotten at the same pace in a pause; without gravity,
/// those in a row during which it hardly moved (`contact_slop`).
///
/// What the count decides (tolerances.h has the constants; that the first two are equal has no
/// meaning):
///
/// | count above                           | condition           | what happens |
/// |---------------------------------------|---------------------|---|
/// | dense_collisions (64)                 | the last with a ball; gravity, losses | the ball is in a dense cluster: `contact` takes it over when the tick ends (hybrid_step.h) |
/// | most_recent_collisions (64)           | of both balls; of one ball at an edge without gravity | a restitution below 1 is 0 (restitution.h) |
/// | most_recent_collisions (64)           | a kinematic body touches the ball | kinematic bodies stop (response.h) |
/// | most_recent_collisions (64)           | jammed, slow; gravity | the ball is frozen, also in an elastic scene |
/// | most_collisions_before_freezing (256) | slow; gravity, losses | the ball is frozen |
///
/// A frozen ball rests without a support until `thaw_time`. Freezing loses energy and momentum. Slow:
/// no faster than after a fall through its radius.
///
/// A ball is *jammed* if its simultaneous impacts do not terminate (response.h). A ball jammed
/// against a frozen one is frozen too. Source of the idea: Luding and McNamara, How to handle the
/// inelastic collapse of a dissipative hard-sphere gas, Granular Matter 1, 1998.
// clang-format on
template <typename Real>
class CollapseGuard {
  public:
    CollapseGuard(const EventScene<Real>& scene, BallTable<Real>& balls,
                  Trajectories<Real>& trajectories)
        : scene_(scene), balls_(balls), trajectories_(trajectories) {}

    void begin_tick() {
        dense_.clear();
        sunk_.clear();
    }

    /// The count of a ball after an impact now; `before` is the trajectory that it ends, and
    /// `position` where it is.
    std::uint32_t count(std::uint32_t ball, const Trajectory<Real>& before,
                        const Vector<Real>& position) const;
    /// What is left of the count now, if no impact ends the trajectory, but the stop speed, the
    /// speed limit or a player: collisions accumulate all the same.
    std::uint32_t remaining(std::uint32_t ball) const;
    /// After the impact: freezes the ball if its count says so. Fast balls that rattle in a narrow
    /// place are not frozen, nor are resting or held ones.
    void freeze_if_due(std::uint32_t ball, bool is_jammed);
    /// When a frozen ball is tried again, s. Pre: gravity.
    Real thaw_time(std::uint32_t ball) const {
        return balls_[ball].line.time + fall_time(ball) * Real(frozen_share);
    }
    static bool is_frozen(const Trajectory<Real>& trajectory) {
        return trajectory.motion == Motion::resting &&
               trajectory.support.kind == SupportId::Kind::nothing;
    }

    /// At an impact the ball overlapped another one by more than `most_sunk`. After more than
    /// `sunk_collisions` in quick succession, which have not opened it, it is in a dense cluster.
    void note_sunk(std::uint32_t ball);
    /// An impact with another ball has left this count: the ball may be in a dense cluster.
    void note_dense(std::uint32_t ball);
    /// The balls that still are at the end of the tick, ascending. Valid until the next call.
    const std::vector<std::uint32_t>& dense();

  private:
    bool may_be_clustered(std::uint32_t ball) const;
    double pauses_since(std::uint32_t ball, const Real& time) const;
    Real fall_time(std::uint32_t ball) const;

    const EventScene<Real>& scene_;
    BallTable<Real>& balls_;
    Trajectories<Real>& trajectories_;
    std::vector<std::uint32_t> dense_;
    std::vector<std::uint32_t> sunk_;
};

}  // namespace carom
