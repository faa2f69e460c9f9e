#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/discrete/kinematics.h"
#include "physics/discrete/step.h"
#include "physics/laws/cloth.h"
#include "physics/laws/free_motion.h"

namespace carom {

/// How the balls of the solvers `discrete` and `substep` move, and how much of its time each has
/// left. In the first step of an update every ball is active, with the whole update as its time.
/// Later steps move only the balls that were pushed back in the step before.
class OverlapMotion {
  public:
    OverlapMotion(const OverlapStep& step, const OverlapKinematics& kinematics)
        : step_(step), kinematics_(kinematics) {}

    void begin_tick(const World& world);
    /// Moves every ball for the whole update. Returns the longest displacement, or 0 where
    /// `measure` is false.
    double move_all(World& world, bool measure);
    /// Moves each active ball for the time that it has left.
    void move_active(World& world);

    /// The displacement of a ball that has moved in this step and has not been pushed yet.
    Vec2 displacement_of(const World& world, std::uint32_t ball) const;
    /// Keeps those of the `pushed` balls active that covered less than the intended distance. The
    /// fraction (distance covered) / (distance intended) of their time is spent; for the rest they
    /// lose the velocity that gravity added. A ball that got nowhere loses the rest of its time.
    /// All other balls are done.
    void keep_time(World& world, std::span<const PushedBall> pushed);
    /// Ends an update: no ball is active.
    void clear_active();

    /// In the first step: none, though all are active.
    std::span<const std::uint32_t> active() const { return active_; }
    /// Pre: not the first step.
    bool is_active(std::uint32_t ball) const { return is_active_[ball] != 0; }

  private:
    template <Terms terms, bool forced>
    double move_all_balls(World& world, bool measure);
    template <Terms terms, bool forced>
    void move_active_balls(World& world);
    template <Terms terms, bool forced>
    Vec2 move(World& world, std::uint32_t ball, const Flight& flight);
    Vec2 move_on_cloth(World& world, std::uint32_t ball, double duration);

    const OverlapStep& step_;
    const OverlapKinematics& kinematics_;
    bool keeps_displacements_ = false;  // a displacement is not just the velocity times its time
    std::vector<std::uint32_t> active_;
    std::vector<std::uint8_t> is_active_;     // by ball
    std::vector<double> left_;                // s of the update, by ball; of the active ones
    std::vector<Vec2> displacement_;          // in this step, by ball; where keeps_displacements_
    std::vector<ClothState<double>> before_;  // the step, on cloth
};

}  // namespace carom
