#pragma once

#include <optional>

#include "terminal/canvas/camera.h"
#include "terminal/draw/draw.h"

/// How the player sees the world: what is drawn, from where, and which ball is chosen.
namespace carom {

struct PlayView {
    ViewOptions options;
    ViewMemory memory;
    Camera camera;
    bool is_fitted = true;     ///< the camera shows the scene as a whole
    bool shows_whole = false;  ///< at pinball: all of the table, not the part around the ball
    bool follows = false;      ///< the camera follows the selected ball
    std::optional<BallId> selected;

    /// Magnifies by `factor`; the place `fixed` of the window stays where it is.
    void zoom(CellPoint fixed, double factor);
    void pan(double columns, double rows);
    /// Shows the scene as a whole; where it does so already, changes between the two ways in which
    /// a pinball table is shown.
    void fit();
    /// The middle of the camera's area.
    CellPoint middle() const;
};

}  // namespace carom
