#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "physics/memory/prefetch.h"
#include "physics/swept/candidates.h"
#include "physics/swept/kinematics.h"
#include "physics/swept/paths.h"
#include "physics/swept/schedule.h"

namespace carom {

/// Predicts the impacts of the solver `swept`: finds the first impact of each ball along its path,
/// and puts it into the schedule. A prediction is void once either body has changed its path; the
/// caller then predicts the ball again.
///
/// If two bodies touch and approach no faster than rounding, that is no impact.
class SweptPrediction {
  public:
    SweptPrediction(const SweptSubstep& step, const SweptPaths& paths,
                    const SweptKinematics& kinematics, SweptCandidates& candidates,
                    SweptSchedule& schedule)
        : step_(step),
          paths_(paths),
          kinematics_(kinematics),
          candidates_(candidates),
          schedule_(schedule) {}

    /// Predicts all balls at the start of the substep. Of each pair, the ball with the lower number
    /// predicts.
    void predict_at_start(const World& world);
    /// Predicts all balls from `now` on. Pre: the schedule is empty.
    void predict_all(const World& world, double now);
    /// Predicts one ball from `now` on.
    void predict(const World& world, std::uint32_t ball, double now);

    /// Whether the other body has changed its path since the prediction.
    bool is_void(const SweptEvent& event) const;
    /// How many pairs have been tested for single balls, since the last call.
    std::uint64_t take_tests() { return std::exchange(tests_, 0); }
    /// In scenes of many balls: prefetches what the next events of the schedule need.
    void prefetch(const World& world) const {
        if (paths_.size() >= too_many_to_cache) prefetch_next(world);
    }

  private:
    void prefetch_next(const World& world) const;
    template <Terms terms>
    void predict_pairs_at_start(const World& world);
    template <Terms terms>
    void predict_one(const World& world, std::uint32_t ball, double now, bool only_higher);
    template <Terms terms>
    void predict_ball(const World& world, std::uint32_t ball, std::uint32_t other, double now,
                      std::optional<SweptEvent>& best) const;
    template <Terms terms>
    void predict_edge(const World& world, std::uint32_t ball, std::uint32_t capsule, Vec2 shift,
                      double now, std::optional<SweptEvent>& best) const;

    const SweptSubstep& step_;
    const SweptPaths& paths_;
    const SweptKinematics& kinematics_;
    SweptCandidates& candidates_;
    SweptSchedule& schedule_;
    std::uint64_t tests_ = 0;
};

}  // namespace carom
