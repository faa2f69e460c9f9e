#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes.h"
#include "geometry/vec2.h"
#include "level/scene/dress.h"

/// What a picture of a pinball table shows besides edges.
namespace carom {

/// A lamp under the glass, or an edge that lights up, such as a target.
struct TableLight {
    Capsule shape;
    bool is_edge = false;    ///< drawn over its edge; else under all edges
    bool is_bumper = false;  ///< an edge: drawn with a cap, lit or not
    bool is_lit = false;     ///< an edge that is not lit looks like any other edge
    std::size_t family = 0;  ///< lights of one family without a colour share one
    std::optional<Rgb24> color{};
    InsertShape insert = InsertShape::circle;
    Vec2 direction{0.0, 1.0};  ///< unit vector: where an arrow points
    std::string text{};        ///< its name on the board
};

/// How far a plunger is pulled, beside it.
struct PowerGauge {
    Vec2 from;
    Vec2 to;             ///< the end when it is full
    double share = 0.0;  ///< 0..1
};

struct TableAnnotations {
    std::vector<TableLight> lights;
    std::vector<Capsule> plungers;  ///< as pulled
    std::vector<PowerGauge> gauges;
    std::vector<Capsule> flippers;  ///< from the pivot to the tip
};

}  // namespace carom
