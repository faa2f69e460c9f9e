#pragma once

#include "geometry/shapes.h"
#include "terminal/canvas/camera.h"

/// A camera for a table that is taller than the window: it shows the full width and as much of the
/// height as keeps balls large enough, and it follows the ball up and down.
namespace carom {

class TableCamera {
  public:
    /// Glides towards a ball at height `ball` that moves up with `speed`, for `seconds` of
    /// wall-clock time. A ball near the centre of the view does not move the camera.
    void follow(double ball, double speed, double seconds);

    /// Glides towards the part around the ball, or back to the whole table.
    void approach(bool near, double seconds);

    /// The camera for this window. It shows the whole table where a ball of `ball_radius` is then
    /// large enough, else a part at least `least_share` of the table high. `ball_rows`: the wanted
    /// diameter of a ball, in rows.
    Camera look(const Box& table, double ball_radius, double ball_rows, const CellArea& area,
                double aspect);

  private:
    double height_ = 0.0;   ///< of the centre of the view, in the world
    double speed_ = 0.0;    ///< upwards, length/s
    double seen_ = 0.0;     ///< height of the view; 0: not known yet
    double share_ = 1.0;    ///< how far it has come near: 0 shows the whole table
    double lowest_ = 0.0;   ///< lowest position of the centre
    double highest_ = 0.0;  ///< highest position of the centre
};

}  // namespace carom
