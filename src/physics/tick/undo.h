#pragma once

#include <vector>

#include "physics/world/world.h"

namespace carom {

/// Undoes a tick that was cancelled half way: restores what emitters, flippers, movers, seesaws,
/// and the motion of balls, hands and kinematic edges have changed in the world. It does not cover
/// what the end of a tick changes (stops, sinks, collision counts, solver memory), which a
/// cancelled tick never reaches.
///
/// There are two other ways to go back. A tick that is repeated because a hand yields is restored
/// from a copy of the world (hands.h); a player's rewind restores a snapshot
/// (game/session/history.h).
class TickUndo {
  public:
    /// Notes the world as it is: a copy of its balls and of all that moves, in memory that is
    /// reused from tick to tick.
    void note(const World& world);
    /// Restores the noted world; the restored parts get new stamps. Pre: at most part of one tick
    /// has been computed since `note`.
    void take_back(World& world) const;

  private:
    Balls balls_;
    bool inelastic_ = false;
    bool rough_ = false;
    std::uint32_t next_ball_ = 0;
    std::vector<Emitter> emitters_;
    std::vector<HeldBall> held_balls_;
    std::vector<HeldCapsule> held_capsules_;
    Hands hands_;
    std::vector<Seesaw> seesaws_;
    bool moves_edges_ = false;
    std::vector<Capsule> shapes_;  // if moves_edges_
};

}  // namespace carom
