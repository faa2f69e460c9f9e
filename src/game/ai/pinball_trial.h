#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "game/ai/pinball_sight.h"
#include "game/pinball/pinball_state.h"
#include "level/scene/scene.h"
#include "physics/solver.h"
#include "physics/world/world.h"

/// What would happen on a pinball table if buttons were pressed: a copy of the game is played
/// ahead, by the same physics and the same rules. Its results are a function of the game alone.
namespace carom {

/// A button that goes down or up some ticks from now.
struct TimedPress {
    std::uint64_t after = 0;
    Button button = Button::left_flipper;
    bool is_down = false;
};

/// A copy of a game of pinball.
struct PinballTrial {
    World world;
    PinballState state;
};

/// How a trial ends.
struct Foreseen {
    double safety = 0.0;  ///< of the balls' places: PinballSight::safety
    /// Of points: 2 for 400, 20 for 40,000 or more. 15 more for each shot that the table's task
    /// asks for, of two at most.
    double gain = 0.0;
    /// The first device that the task asked for, else the one whose first event won most. None:
    /// nothing was won.
    std::optional<std::uint32_t> device;
};

/// Plays the trial on by a tick.
void play_tick(const Scene& scene, Solver& solver, PinballTrial& trial);

/// Plays the trial on, with these presses, ascending in time, and judges it after this many ticks;
/// earlier once all balls are lost, or one is back near the flippers, or, if `ends_when_away`, none
/// is near them any more; up to 0.8 s later while a ball is in a lane beside the flippers.
Foreseen play_ahead(const PinballSight& sight, const Scene& scene, Solver& solver,
                    PinballTrial trial, const std::vector<TimedPress>& presses, std::uint64_t ticks,
                    bool ends_when_away);

}  // namespace carom
