#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "game/commands/command.h"
#include "game/pinball/pinball_state.h"
#include "level/scene/scene.h"
#include "physics/world/world.h"

/// carom at its own tables: it presses the buttons that a person would press, sees no more than a
/// person sees, and makes a person's mistakes. What it does depends on the world and on what it did
/// before alone, never on a clock, so that its games are the same everywhere.
namespace carom {

class DemoPlayer {
  public:
    /// What it presses and lets go now, before the next tick. Asked once a tick.
    std::vector<command::Press> play(const Scene& scene, const World& world,
                                     const PinballState& state);

  private:
    /// What it has made up its mind to do with a flipper button.
    struct Hand {
        std::uint64_t up_from = 0;
        std::uint64_t up_until = 0;
        std::uint64_t busy_until = 0;  ///< sees nothing else meanwhile
    };
    void watch_flipper(const Scene& scene, const World& world, std::size_t flipper);
    bool wants_nudge(const World& world, const PinballState& state) const;

    std::array<Hand, 2> hands_{};
    std::uint64_t seen_until_ = 0;
    std::uint64_t flips_ = 0;
    std::uint64_t begins_at_ = 0;  ///< another game
    std::uint64_t nudged_at_ = 0;
    Button nudge_ = Button::nudge_up;
};

}  // namespace carom
