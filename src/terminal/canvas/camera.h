#pragma once

#include "geometry/shapes.h"

/// Where the world stands on the canvas: a camera maps world points to places in cells and back.
namespace carom {

/// A rectangle of cells of a canvas.
struct CellArea {
    int column = 0;  ///< of its left edge
    int row = 0;     ///< of its top edge
    int columns = 0;
    int rows = 0;

    friend bool operator==(const CellArea&, const CellArea&) = default;
};

/// A place on the canvas, finer than a cell: the middle of the cell in column 3 of row 5 is
/// {3.5, 5.5}. Rows count downwards.
struct CellPoint {
    double column = 0.0;
    double row = 0.0;

    friend bool operator==(const CellPoint&, const CellPoint&) = default;
};

struct Camera {
    CellArea area;                    ///< the part of the canvas that it fills
    Vec2 center;                      ///< the world point in the middle of the area, length
    double columns_per_length = 1.0;  ///< > 0, finite
    double aspect = 2.0;              ///< height of a cell over its width, > 0, finite

    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Shows all of `view`, as large as it fits, in the middle of the area, with a margin of half a
/// column. A view without extent is shown as if it were 2 wide; an area without cells counts as one
/// cell; an aspect that is not positive and finite counts as 2.
Camera fit_camera(const Box& view, const CellArea& area, double aspect);

CellPoint to_cells(const Camera& camera, Vec2 point);
Vec2 to_world(const Camera& camera, CellPoint place);

/// What the camera shows, a box in the world.
Box visible_box(const Camera& camera);

/// Larger by `factor` (smaller when below 1); the world point at `fixed` stays where it is. Factors
/// that are not positive and finite change nothing; the scale stays within 1e-12 to 1e12.
Camera zoomed(const Camera& camera, CellPoint fixed, double factor);

/// Looks further right by `columns` and further down by `rows`.
Camera panned(const Camera& camera, double columns, double rows);

/// The camera for another area: it keeps the middle, and everything visible stays visible.
Camera resized(const Camera& camera, const CellArea& area, double aspect);

}  // namespace carom
