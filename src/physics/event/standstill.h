#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/event/motion/ball_table.h"
#include "physics/event/motion/scene.h"
#include "physics/event/motion/trajectories.h"
#include "physics/event/rest/cloth_phases.h"

namespace carom {

/// The balls for which time stands still until the tick ends, because they have used their share of
/// the work (tick/work_budget.h). Such a ball is an immovable obstacle at its place until the tick
/// ends, and then continues with the velocity, roll and spin that it had.
template <typename Real>
class Standstill {
  public:
    Standstill(const EventScene<Real>& scene, BallTable<Real>& balls,
               Trajectories<Real>& trajectories, ClothPhases<Real>& cloth)
        : scene_(scene), balls_(balls), trajectories_(trajectories), cloth_(cloth) {}

    void begin_tick() {
        motions_.clear();
        standing_.clear();
    }
    /// Time stands still for the ball from now on; the caller predicts it. Pre: it is not held.
    void stop(std::uint32_t ball);
    /// Ends the tick: starts the trajectories on which these balls continue in the next tick, which
    /// must rebuild.
    void end_tick();

    bool is_empty() const { return standing_.empty(); }
    /// By index.
    std::span<const std::uint32_t> balls() const { return standing_; }

  private:
    struct Motions {
        Vector<Real> velocity;
        Vector<Real> roll;
        Real spin{};
    };

    const EventScene<Real>& scene_;
    BallTable<Real>& balls_;
    Trajectories<Real>& trajectories_;
    ClothPhases<Real>& cloth_;
    std::vector<std::uint32_t> standing_;
    std::vector<Motions> motions_;  // of standing_
};

}  // namespace carom
