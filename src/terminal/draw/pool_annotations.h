#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes.h"
#include "physics/world/ids.h"

/// What a picture of a pool table shows besides balls and cushions.
namespace carom {

struct PoolAnnotations {
    /// The number on a ball; 0: the cue ball.
    struct Number {
        BallId ball{};
        int number = 0;
    };
    struct Line {
        Vec2 from;
        Vec2 to;
    };
    /// The predicted path of a ball.
    struct Track {
        BallId ball{};
        std::vector<Vec2> way;
        bool is_pocketed = false;  ///< into a pocket, at the end of its path
    };
    /// A predicted resting position of a ball.
    struct Spot {
        BallId ball{};
        Vec2 place;
        bool is_pocketed = false;
    };

    /// A ball that was off the table and is back, under a new id: it keeps its colour.
    struct Returned {
        BallId ball{};
        BallId before{};  ///< as at the start
    };

    std::vector<Number> numbers;
    std::vector<Returned> returned;
    std::optional<Line> stick;   ///< the cue, from its tip to its butt
    std::optional<Line> aim;     ///< from the ball to its first impact
    std::optional<Line> object;  ///< the path of the object ball
    std::optional<Line> tangent;
    std::optional<Disc> ghost;  ///< the ghost ball: the cue ball at the impact
    std::vector<Track> tracks;
    std::vector<Spot> spots;
    std::optional<Vec2> called;  ///< the called pocket
};

}  // namespace carom
