#pragma once

#include <span>
#include <vector>

#include "physics/tick/kinematic.h"

namespace carom {

/// The kinematic bodies of the solvers `discrete` and `substep`. They move to their targets
/// whatever is in between; balls that they overlap are pushed out afterwards.
class OverlapKinematics {
  public:
    /// Reads the masses and the held bodies for a tick. The world must outlive the tick.
    void begin_tick(const World& world);
    /// Moves each by `share` of the remaining displacement to its target, in an update of
    /// `duration` s.
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
