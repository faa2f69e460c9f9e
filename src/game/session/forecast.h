#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "game/commands/command.h"
#include "game/session/game_state.h"
#include "level/scene/scene.h"
#include "physics/solver.h"
#include "physics/world/world.h"

/// The outcome of a shot, in advance: the engine runs ahead on a copy until the balls lie still.
/// The forecast is exact to the last bit unless somebody acts before.
namespace carom {

struct Forecast {
    struct Track {
        BallId ball{};
        std::vector<Vec2> way;  ///< its position now, and after each tick while it moves
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
