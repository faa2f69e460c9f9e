#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "game/commands/command.h"
#include "game/pinball/pinball_state.h"
#include "level/scene/scene.h"
#include "physics/world/world.h"

/// The AI player of pinball. It traps a ball that comes slowly, waits until it lies still, lets it
/// roll off and shoots when it is where the shot wants it; faster balls it flips as they come. With
/// several balls in play it only flips. It presses the same buttons as a person, sees no more than
/// a person sees, and makes similar mistakes. Its play is a function of the world and of its own
/// past, never of a clock, so its games are equal on every machine.
namespace carom {

class DemoPlayer {
  public:
    /// The buttons that the player presses and releases before the next tick. Called once a tick.
    std::vector<command::Press> play(const Scene& scene, const World& world,
                                     const PinballState& state);

  private:
    /// The plan for one flipper button, in ticks.
    struct FlipperPlan {
        std::uint64_t up_from = 0;
        std::uint64_t up_until = 0;
        std::uint64_t busy_until = 0;  ///< until then it considers no other ball
    };
    /// The ball that a flipper traps, and what it is going to do with it.
    struct Cradle {
        bool holds = false;       ///< the flipper is up, to trap
        bool aims = false;        ///< let go, and waiting for the ball to reach `place`
        std::uint64_t since = 0;  ///< tick at which this began
        std::uint64_t still = 0;  ///< ticks for which the ball has lain still
        double place = 0.0;       ///< along the flipper
    };
    void watch_flipper(const Scene& scene, const World& world, std::size_t flipper);
    /// Whether the flipper is busy with a trapped ball.
    bool cradle(const Scene& scene, const World& world, std::size_t flipper);
    void flip(const World& world, FlipperPlan& plan);
    std::optional<Button> wanted_nudge(const World& world, const PinballState& state) const;

    std::array<FlipperPlan, 2> plans_{};
    std::vector<Cradle> cradles_;  ///< by flipper
    std::uint64_t seen_until_ = 0;
    std::uint64_t flips_ = 0;
    std::uint64_t begins_at_ = 0;  ///< the tick at which it starts another game
    std::uint64_t nudged_at_ = 0;
    Button nudge_ = Button::nudge_up;
};

}  // namespace carom
