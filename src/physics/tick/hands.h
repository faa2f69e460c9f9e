#pragma once

#include <cstdint>
#include <vector>

#include "physics/broad_phase/near_pairs.h"
#include "physics/world/world.h"

/// Hands: how far the balls and edges that a player holds move in a tick. Flippers are not hands.
///
/// A hand moves straight towards its target, no faster than the target itself moves (its pace). It
/// *yields*: a tick moves it only so far that the balls which it pushes can get out of its way. So
/// it stops at what it cannot move, and continues when it can, without making up for lost time.
///
/// How far is found by trial: Solver::tick computes the tick with a share of the displacements of
/// all hands. If the result is not sound (`is_sound`), it restores the world from a copy and tries
/// half that share, down to 1/64, and then 0: the hands do not move. The next tick starts from
/// twice the last share, at most 1. Balls that a hand has thrown may squash others even then: where
/// that makes overlaps too deep, and the solver can be strict (TickWork::is_strict), the tick is
/// computed once more, strictly.
///
/// A solver therefore sees a hand as a ball or an edge in uniform motion through the tick, at the
/// velocity of its displacement, and need not handle hands that cannot move on. What a solver does
/// with a ball that is squeezed within one trial is its own (docs/physics.md, Kinematic bodies).
///
/// Units: length and s of the level.
namespace carom {

/// Moves the hands through a tick.
class HandStep {
  public:
    /// Begins a tick: measures the pace of each hand. Returns whether a hand holds anything.
    bool begin(World& world);

    /// The share of the hands' displacements to try first.
    double first_share() const { return share_; }
    /// The share to try when `share` was not sound; 0 in the end.
    static double next_share(double share);

    /// Sets the targets in the world to where the hands would be at the end of this tick.
    void aim(World& world, double share);
    /// Ends the tick: sets the targets in the world to the player's again, and stores the share.
    void end(World& world, double share) const;

    /// Whether the tick from `before` to `after` is free of what a hand must not cause:
    /// - a ball faster than twice the fastest pace, or than the fastest ball before, and what
    ///   gravity adds in two ticks;
    /// - a ball that has crossed a held edge;
    /// - a pair that overlaps deeper than before, and by 0.02 radii more than the deepest overlap
    ///   when the first hand took hold.
    bool is_sound(const World& before, const World& after);
    /// The last of these alone.
    bool is_free_of_overlap(const World& before, const World& after);

  private:
    template <typename Visit>
    void for_each_overlap(const World& world, Visit&& visit);
    double deepest_overlap(const World& world);

    double share_ = 1.0;
    double fastest_ = 0.0;  // pace of the fastest hand
    std::vector<HeldBall> balls_;
    std::vector<HeldCapsule> edges_;
    // Scratch.
    Hands hands_;
    std::vector<HeldBall> aimed_balls_;
    std::vector<HeldCapsule> aimed_edges_;
    NearPairs near_;
    std::vector<double> margin_;
};

}  // namespace carom
