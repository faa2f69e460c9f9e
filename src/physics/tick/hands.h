#pragma once

#include <cstdint>
#include <vector>

#include "physics/broad_phase/near_pairs.h"
#include "physics/world/world.h"

/// Hands: what moves the balls and edges that a player holds. Flippers are none.
///
/// A hand goes straight to its target, at the pace at which the target goes. It *yields*: in a tick
/// it goes only so far that the balls which it pushes can get out of its way. So it stops at what
/// it cannot move, stays there, and goes on when it can; it never catches up faster than its pace.
///
/// How far that is, the tick itself tells. It is computed with the whole way, and again with a
/// half, a quarter and so on of it, until the balls keep what a hand may not break (`is_sound`); at
/// last with hands that stand still. The next tick begins with twice the share of the last. So no
/// solver needs to know about hands that cannot advance: for each of them a hand is an edge or a
/// ball that moves uniformly through the tick, and its velocity at an impact is that of its path.
///
/// Units: length and s of the level.
namespace carom {

/// Takes the hands through a tick.
class HandStep {
  public:
    /// Begins a tick: measures the pace of each hand. Whether anything is held.
    bool begin(World& world);

    /// The share of their ways to try first.
    double first_share() const { return share_; }
    /// The share to try after `share` was too much; 0 in the end.
    static double next_share(double share);

    /// Sets the targets in the world to where the hands would be at the end of this tick.
    void aim(World& world, double share);
    /// Ends the tick: the targets are the player's again.
    void end(World& world, double share) const;

    /// Whether the balls keep what a hand may not break. `before` is the world before the tick.
    bool is_sound(const World& before, const World& after);

  private:
    template <typename Visit>
    void for_each_overlap(const World& world, Visit&& visit);
    double deepest_overlap(const World& world);
    bool is_free_of_overlap(const World& before, const World& after);

    double share_ = 1.0;
    double fastest_ = 0.0;  // pace of the fastest hand
    std::vector<HeldBall> balls_;
    std::vector<HeldCapsule> edges_;
    // Scratch.
    Hands hands_;
    std::vector<HeldBall> aimed_balls_;
    std::vector<HeldCapsule> aimed_edges_;
    NearPairs near_;
    std::vector<std::uint32_t> order_;
    std::vector<double> margin_;
};

}  // namespace carom
