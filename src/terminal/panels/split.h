#pragma once

#include <cstdint>
#include <string>

#include "geometry/shapes.h"
#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"

/// Split view: a window in two halves, each with a title over its picture.
namespace carom {

struct Split {
    CellArea first_title;  ///< one row
    CellArea first;
    CellArea second_title;
    CellArea second;   ///< as large as the first
    CellArea divider;  ///< a column; empty where the halves are stacked
};

/// Side by side, unless `view` shows larger in stacked halves.
Split split(const CellArea& area, const Box& view, double aspect);

struct HalfTitle {
    std::string solver;  ///< with its settings
    std::uint64_t tick = 0;
    std::uint64_t collisions = 0;
};

/// Draws the titles and the divider.
void draw_split(Canvas& canvas, const Split& split, const HalfTitle& first, const HalfTitle& second,
                const Look& look);

}  // namespace carom
