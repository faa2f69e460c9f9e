#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/vec2.h"
#include "level/scene/games.h"
#include "physics/world/ids.h"

/// The pool table of a level: its cue, racks, pockets, and the length of a match.
namespace carom {

/// The ball that the cue strikes, and the speeds that a stroke may give it, length/s.
struct Cue {
    BallId ball{};
    /// Those among which the player chooses, in `game shots`; `ball` is the first.
    std::vector<BallId> balls{};
    double least_power = 0.0;
    double most_power = 0.0;
    double scatter = 0.0;  ///< standard deviation of the direction of a player's strokes, degrees
};

struct Rack {
    const RackLayout* layout = nullptr;
    /// Ball n is balls[n - 1]. The balls of a triangle are numbered row by row.
    std::vector<BallId> balls;
    Vec2 foot;                            ///< the foot spot: the position of the apex ball
    Vec2 toward;                          ///< unit vector from the apex towards the back row
    double gap = 0.0;                     ///< between neighbours
    std::optional<std::uint64_t> seed{};  ///< see racking.h
};

/// What a level may choose of the rules of its game of pool.
struct PoolRules {
    bool nine_on_break_wins = true;  ///< 9-ball; else the 9 is spotted
    int fouls_that_lose = 3;         ///< in a row, in games that count them; 0: never
    int points = 100;                ///< straight pool: that win a frame
    int stalemate = 0;           ///< shots in a row that pocket nothing, after which the balls are
                                 ///< racked again; 0: never
    bool winner_breaks = false;  ///< the next frame; else the players take turns
    bool is_tossed = false;      ///< a coin decides who breaks first, by the level's seed
};

/// The D of snooker: a semicircle on the baulk line. Yellow, brown and green have their spots at
/// its right corner, its middle and its left corner.
struct BaulkD {
    Vec2 middle;
    double radius = 0.0;
};

struct PoolTable {
    std::optional<Cue> cue;  ///< the first of `cues`
    std::vector<Cue> cues;   ///< of `game shots`, one for each player in turn; else one at most
    std::vector<Rack> racks;
    /// The object balls of the game that are not racked: GameRow::others, in that order.
    std::vector<BallId> others{};
    std::optional<BaulkD> d{};
    std::vector<std::uint32_t> pockets;  ///< indices into World::zones
    std::uint32_t race = 0;              ///< frames that win the match; 0: the match has no end
    double clock = 0.0;                  ///< the shot clock, s; 0: none
    PoolRules rules;
};

}  // namespace carom
