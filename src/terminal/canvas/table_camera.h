#pragma once

#include "geometry/shapes.h"
#include "terminal/canvas/camera.h"

/// A camera for a table that is taller than the window: it shows all of the width, and as much of
/// the height as keeps balls large enough, and follows the ball up and down.
namespace carom {

class TableCamera {
  public:
    /// Glides towards a ball at height `ball` that moves up with `speed` for `seconds` of the
    /// person's time. Balls near the middle of what is seen do not move it.
    void follow(double ball, double speed, double seconds);

    /// All of the table where a ball of this radius is large enough then, else a part of it as high
    /// as `least_share` of the table or more. `ball_rows`: how many rows a ball should have across.
    Camera look(const Box& table, double ball_radius, double ball_rows, const CellArea& area,
                double aspect);

  private:
    double height_ = 0.0;   ///< of what is in the middle, in the world
    double speed_ = 0.0;    ///< upwards, length/s
    double seen_ = 0.0;     ///< height that is seen; 0: not known yet
    double lowest_ = 0.0;   ///< that the middle can be at
    double highest_ = 0.0;  ///< that the middle can be at
};

}  // namespace carom
