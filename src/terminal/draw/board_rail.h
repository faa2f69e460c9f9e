#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "level/scene/scene.h"

/// The grid on which the board of a level is found, and the rails around it.
namespace carom {

/// Square cells that cover a box, row by row from its lower left.
struct BoardGrid {
    Box box;
    double cell = 1.0;
    int columns = 0;
    int rows = 0;

    std::size_t size() const {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
    Vec2 middle(int column, int row) const {
        return box.low + Vec2{(column + 0.5) * cell, (row + 0.5) * cell};
    }
    int column_of(double x) const {
        return static_cast<int>(std::clamp((x - box.low.x) / cell, 0.0, columns - 1.0));
    }
    int row_of(double y) const {
        return static_cast<int>(std::clamp((y - box.low.y) / cell, 0.0, rows - 1.0));
    }
    std::size_t index_of(Vec2 place) const { return index(column_of(place.x), row_of(place.y)); }
};

/// For each cell of a grid, whether it is set.
using CellMask = std::vector<std::uint8_t>;

/// The distance of each cell from the bed, in cells. On a pool table the mouths of pockets and what
/// pockets bite off do not count, so that the frame runs straight and has square corners.
std::vector<float> distance_from_bed(const Scene& scene, const BoardGrid& grid,
                                     const CellMask& bed);

/// Widths of the rail and of its inner part, the cushion, length.
struct RailWidths {
    double rail = 0.0;
    double cushion = 0.0;
};
RailWidths rail_widths(const Scene& scene);

/// The cells of the bed that are no wider than an edge: jaws of pockets, which lead off it.
CellMask jaws_of(const Scene& scene, const BoardGrid& grid, const CellMask& bed);

/// The width, in cells, of a rail that contains the jaws of the pockets, edges that lead off the
/// bed. `far`: distances from the bed; `rail`: the width without jaws, in cells.
double rail_around_jaws(const Scene& scene, const BoardGrid& grid, const std::vector<float>& far,
                        double rail);

}  // namespace carom
