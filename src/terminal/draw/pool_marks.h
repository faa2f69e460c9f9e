#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes.h"
#include "physics/world/ids.h"

/// What a picture of a pool table shows beyond the balls and the cushions.
namespace carom {

struct PoolMarks {
    /// The number on a ball; 0: the cue ball.
    struct Number {
        BallId ball{};
        int number = 0;
    };
    struct Line {
        Vec2 from;
        Vec2 to;
    };
    /// Where a ball will go.
    struct Track {
        BallId ball{};
        std::vector<Vec2> way;
        bool falls = false;  ///< into a pocket, at its end
    };
    /// Where a ball may come to lie.
    struct Spot {
        BallId ball{};
        Vec2 place;
        bool falls = false;
    };

    std::vector<Number> numbers;
    std::optional<Box> cloth;    ///< drawn as such where there are colours for it
    std::optional<Line> stick;   ///< the cue: from its tip to its butt
    std::optional<Line> aim;     ///< from the ball to where it meets something
    std::optional<Line> object;  ///< the way of the ball that it meets
    std::optional<Line> tangent;
    std::optional<Disc> ghost;  ///< the cue ball where it meets the other
    std::vector<Track> tracks;
    std::vector<Spot> spots;
    std::optional<Vec2> called;  ///< the pocket
};

}  // namespace carom
