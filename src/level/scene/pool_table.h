#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/vec2.h"
#include "physics/world/ids.h"

/// What of a level is a pool table: the cue, the racks, the pockets, how long a match is.
namespace carom {

/// Which ball the cue strikes, and how hard it may, length/s.
struct Cue {
    BallId ball{};
    double least_power = 0.0;
    double most_power = 0.0;
};

struct Rack {
    enum class Shape : std::uint8_t { eight, nine, triangle };
    Shape shape = Shape::eight;
    /// Ball n is balls[n - 1]; where a triangle was racked, they are numbered row by row.
    std::vector<BallId> balls;
    Vec2 foot;    ///< where the apex ball stands
    Vec2 toward;  ///< unit: the way of the rows, away from the apex
};

struct PoolTable {
    std::optional<Cue> cue;
    std::vector<Rack> racks;
    std::vector<std::uint32_t> pockets;  ///< indices into World::zones
    std::uint32_t race = 0;              ///< frames that win a match; 0: it has no end
    double clock = 0.0;                  ///< for each shot, s; 0: a player has any time
};

}  // namespace carom
