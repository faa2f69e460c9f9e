#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "game/ai/pinball_options.h"
#include "game/ai/pinball_plunge.h"
#include "game/ai/pinball_sight.h"
#include "game/ai/pinball_trial.h"
#include "game/commands/command.h"
#include "game/pinball/pinball_state.h"
#include "level/scene/scene.h"
#include "physics/world/world.h"

/// The AI player of pinball. It thinks ahead by trials (pinball_trial.h):
///
///   a ball lies in a cradle   it tries letting it roll off and pressing at each moment, and shoots
///                             where that wins most
///   a ball comes down         it tries to catch it, to let it bounce, and to flip it, each at
///                             several moments, and does what leaves the balls in the best places
///   a ball would be lost      it tries to nudge it to safety
///   a ball is to be launched  it tries pulls of the plunger, and takes the one that wins most
///
/// It presses the same buttons as a person, and later or earlier than it wanted, as a person does.
/// Its play is a function of the world and of its own past, never of a clock, so its games are
/// equal on every machine.
namespace carom {

class DemoPlayer {
  public:
    /// The buttons that the player presses and releases before the next tick. Called once a tick.
    std::vector<command::Press> play(const Scene& scene, const World& world,
                                     const PinballState& state);

    /// Shots from a cradle so far.
    struct Shots {
        std::uint64_t tried = 0;
        std::uint64_t made = 0;  ///< the device was hit that the shot was meant for
    };
    const Shots& shots() const { return shots_; }

  private:
    /// A game, as it is before the next tick.
    struct Game {
        const Scene& scene;
        const World& world;
        const PinballState& state;
        const PinballSight& sight;
    };
    struct DuePress {
        std::uint64_t tick = 0;
        Button button = Button::left_flipper;
        bool is_down = false;
    };
    /// The ball in a cradle, and what is known of the shots from there.
    struct Cradle {
        std::size_t flipper = 0;
        std::uint64_t since = 0;
        std::uint64_t rolls = 0;              ///< ticks that `rolling` has rolled
        std::optional<PinballTrial> rolling;  ///< the game after the flipper is let go
        std::vector<PinballOption> shots;
    };
    /// A shot that is on its way to its device.
    struct Shot {
        std::uint32_t device = 0;
        std::uint64_t from = 0;
        std::uint64_t until = 0;
        std::optional<std::uint32_t> events_before;  ///< of the device's group; from `from` on
    };

    void decide(const Game& game);
    bool aim(const Game& game, const std::vector<std::size_t>& near);
    void try_next_shot(const Game& game);
    void shoot(const Game& game);
    void meet(const Game& game, std::size_t ball);
    PinballTrial seen(const Game& game);
    PinballOption delayed(const Game& game, PinballOption option);
    void follow(const Game& game, const PinballOption& option);
    void watch_shot(const Game& game);
    double error(const World& world, double most);

    std::optional<SolverSettings> settings_;  ///< of trials
    std::vector<DuePress> due_;
    std::array<bool, button_count> wants_down_{};
    std::optional<Cradle> cradle_;
    std::optional<Shot> shot_;
    PinballPlunge plunge_;
    Shots shots_;
    std::uint64_t decides_at_ = 0;
    std::uint64_t acted_at_ = 0;  ///< the last press, or the last tick with no ball near
    std::uint64_t errors_ = 0;    ///< drawn so far
    std::uint64_t seen_until_ = 0;
    std::uint64_t begins_at_ = 0;  ///< the tick at which it starts another game
};

}  // namespace carom
