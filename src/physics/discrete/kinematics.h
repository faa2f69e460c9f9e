#pragma once

#include <span>
#include <vector>

#include "physics/tick/kinematic.h"

namespace carom {

/// The kinematic bodies of the solvers `discrete` and `substep`. They go their way whatever is in
/// it; balls are pushed out of it afterwards.
class OverlapKinematics {
  public:
    /// Takes up the masses for a tick. The world must outlive it.
    void begin_tick(const World& world);
    /// Moves each by `share` of its remaining way, in an update of `duration` s.
    void move(World& world, double share, double duration);

    /// By ball, 1/mass; 0 where it is held.
    std::span<const double> inverse_mass() const { return inverse_mass_; }
    bool is_held(std::uint32_t ball) const { return inverse_mass_[ball] == 0.0; }
    /// Longest displacement of a held ball in this update.
    double longest_displacement() const { return longest_displacement_; }
    /// Null for an edge that is fixed.
    const HeldEdge* find(std::uint32_t capsule) const {
        return find_edge(std::span<const HeldEdge>(edges_), capsule);
    }

  private:
    std::span<const double> inverse_mass_;  // the world's, or with_held_balls_
    std::vector<double> with_held_balls_;
    std::vector<HeldEdge> edges_;
    double longest_displacement_ = 0.0;
};

}  // namespace carom
