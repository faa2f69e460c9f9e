#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "game/commands/command.h"
#include "game/session/game_state.h"
#include "level/scene/scene.h"
#include "physics/solver.h"
#include "physics/world/world.h"

/// Predicts the outcome of a shot: the engine runs ahead on a copy until the balls are at rest. The
/// forecast is exact to the last bit unless a command intervenes. For the path of the struck ball
/// alone, a given number of ticks ahead, see predict.h; for aiming lines without a simulation,
/// commands/aiming.h.
namespace carom {

struct Forecast {
    struct Track {
        BallId ball{};
        std::vector<Vec2>
            way;  ///< its present position, and its position after each tick while it moves
        std::optional<std::uint32_t> zone;  ///< the zone that removes it; none: it stays
    };
    /// For each ball that moves, ascending by ball; empty unless asked for.
    std::vector<Track> tracks;
    std::optional<BallId> first_hit;  ///< the ball that the struck ball hits first
    World world;                      ///< at the end
    GameState game;
    bool comes_to_rest = false;  ///< within the given time
};

enum class Tracks : std::uint8_t { none, all };

/// Simulates at most `seconds` ahead. Pre: the strike is not refused.
Forecast forecast(const Scene& scene, const World& world, const GameState& game, Solver& solver,
                  const command::Strike& strike, double seconds, Tracks tracks);

}  // namespace carom
