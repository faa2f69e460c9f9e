#pragma once

#include <vector>

#include "physics/world/world.h"

namespace carom {

/// The way back from within a tick: what births, flippers and the motion of balls and held edges
/// change in a world. Not what the end of a tick changes (stops, sinks, counts, paths).
class TickUndo {
  public:
    /// Notes how the world is: about 32 bytes a ball, in memory that is kept.
    void note(const World& world);
    /// The world is as it was when it was noted. Pre: it has gone through a part of a tick since.
    void take_back(World& world) const;

  private:
    std::size_t balls_ = 0;
    bool lossy_ = false;
    std::uint32_t next_ball_ = 0;
    std::vector<Vec2> position_;
    std::vector<Vec2> velocity_;
    std::vector<double> spin_;
    std::vector<Vec2> roll_;
    std::vector<std::uint32_t> edge_contacts_;
    std::vector<Emitter> emitters_;
    std::vector<HeldCapsule> held_capsules_;
    std::vector<Capsule> shapes_;  // where some may move
};

}  // namespace carom
