#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "game/commands/command.h"
#include "game/pinball/pinball_state.h"
#include "level/scene/scene.h"
#include "physics/world/world.h"

/// The AI player of pinball. It presses the same buttons as a person, sees no more than a person
/// sees, and makes similar mistakes. Its play is a function of the world and of its own past, never
/// of a clock, so its games are equal on every machine.
namespace carom {

class DemoPlayer {
  public:
    /// The buttons that it presses and releases before the next tick. Called once a tick.
    std::vector<command::Press> play(const Scene& scene, const World& world,
                                     const PinballState& state);

  private:
    /// The plan for one flipper button, in ticks.
    struct FlipperPlan {
        std::uint64_t up_from = 0;
        std::uint64_t up_until = 0;
        std::uint64_t busy_until = 0;  ///< until then it considers no other ball
    };
    void watch_flipper(const Scene& scene, const World& world, std::size_t flipper);
    bool wants_nudge(const World& world, const PinballState& state) const;

    std::array<FlipperPlan, 2> plans_{};
    std::uint64_t seen_until_ = 0;
    std::uint64_t flips_ = 0;
    std::uint64_t begins_at_ = 0;  ///< the tick at which it starts another game
    std::uint64_t nudged_at_ = 0;
    Button nudge_ = Button::nudge_up;
};

}  // namespace carom
