#pragma once

#include <cstdint>
#include <string>

#include "geometry/shapes.h"
#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"

/// A window in two halves, each with a title over its picture.
namespace carom {

struct Split {
    CellArea first_title;  ///< one row
    CellArea first;
    CellArea second_title;
    CellArea second;   ///< as large as the first
    CellArea divider;  ///< a column; empty where one half stands over the other
};

/// Side by side, unless `view` shows larger with one half over the other.
Split split(const CellArea& area, const Box& view, double aspect);

struct HalfTitle {
    std::string solver;  ///< with its settings
    std::uint64_t tick = 0;
    std::uint64_t collisions = 0;
};

/// The titles and the divider.
void draw_split(Canvas& canvas, const Split& split, const HalfTitle& first, const HalfTitle& second,
                const Look& look);

}  // namespace carom
