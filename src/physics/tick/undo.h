#pragma once

#include <vector>

#include "physics/world/world.h"

namespace carom {

/// Takes back a tick that was cancelled half way: restores what emitters, flippers, the motion of
/// balls and kinematic edges have changed in the world. It does not cover what the end of a tick
/// changes (stops, sinks, collision counts, the memory of solvers), which a cancelled tick never
/// reaches.
class TickUndo {
  public:
    /// Remembers the world as it is: a copy of its balls and of what moves, in memory that is
    /// reused from tick to tick.
    void note(const World& world);
    /// Restores the world that was noted. Pre: at most part of one tick has been computed since
    /// `note`.
    void take_back(World& world) const;

  private:
    Balls balls_;
    bool lossy_ = false;
    std::uint32_t next_ball_ = 0;
    std::vector<Emitter> emitters_;
    std::vector<HeldBall> held_balls_;
    std::vector<HeldCapsule> held_capsules_;
    Hands hands_;
    bool moves_edges_ = false;
    std::vector<Capsule> shapes_;  // if moves_edges_
};

}  // namespace carom
