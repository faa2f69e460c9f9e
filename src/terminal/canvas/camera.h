#pragma once

#include "geometry/shapes.h"
#include "terminal/canvas/canvas.h"

/// A camera maps world points to positions on the canvas, in cells, and back.
namespace carom {

/// A position on the canvas, finer than a cell: the centre of the cell in column 3 of row 5 is
/// {3.5, 5.5}. Rows count downwards.
struct CellPoint {
    double column = 0.0;
    double row = 0.0;

    friend bool operator==(const CellPoint&, const CellPoint&) = default;
};

struct Camera {
    CellArea area;                    ///< the part of the canvas that the view fills
    Vec2 center;                      ///< the world point at the centre of the area, length
    double columns_per_length = 1.0;  ///< > 0, finite
    double aspect = 2.0;              ///< height of a cell over its width, > 0, finite

    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Columns around a view that is fitted into an area, so that walls at its edge are seen.
inline constexpr double fit_margin = 0.5;

/// A camera that fits all of `view` into the area, centred. A small area has no margin. A view of
/// zero extent is shown as if it were 2 wide; an area without cells counts as one cell; an aspect
/// that is not positive and finite counts as 2. Pre: margin >= 0.
Camera fit_camera(const Box& view, const CellArea& area, double aspect, double margin = fit_margin);

/// A camera that shows `part` alone: its area is the middle of `area`, and no larger than the cells
/// that the part and the margin around it touch.
Camera fit_camera_to_part(const Box& part, const CellArea& area, double aspect);

CellPoint to_cells(const Camera& camera, Vec2 point);
Vec2 to_world(const Camera& camera, CellPoint place);

/// The part of the world in view.
Box visible_box(const Camera& camera);

/// The camera zoomed in by `factor` (out when below 1); the world point at `fixed` stays where it
/// is. A factor that is not positive and finite changes nothing; the scale is clamped to
/// 1e-12..1e12.
Camera zoomed(const Camera& camera, CellPoint fixed, double factor);

/// The camera moved by `columns` to the right and `rows` down.
Camera panned(const Camera& camera, double columns, double rows);

/// The camera for an area of another size: it keeps the centre, and everything visible stays
/// visible.
Camera resized(const Camera& camera, const CellArea& area, double aspect);

}  // namespace carom
