#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "game/commands/command.h"
#include "game/session/game_state.h"
#include "level/scene/scene.h"
#include "physics/solver.h"
#include "physics/world/world.h"

/// What comes of a shot, known before: the engine itself, run ahead on a copy until the balls lie
/// still, so it is right to the last bit unless somebody acts before.
namespace carom {

struct Forecast {
    struct Track {
        BallId ball{};
        std::vector<Vec2> way;              ///< its place now, and after each tick while it moves
        std::optional<std::uint32_t> zone;  ///< the zone that takes it; none: it stays
    };
    /// Of the balls that move, ascending by ball; empty unless asked for.
    std::vector<Track> tracks;
    std::optional<BallId> first_hit;  ///< what the ball that is struck meets first
    World world;                      ///< as it lies then
    GameState game;
    bool comes_to_rest = false;  ///< within the time that was given
};

enum class Tracks : std::uint8_t { none, all };

/// Looks `seconds` ahead at most. Pre: the strike is not refused.
Forecast forecast(const Scene& scene, const World& world, const GameState& game, Solver& solver,
                  const command::Strike& strike, double seconds, Tracks tracks);

}  // namespace carom
