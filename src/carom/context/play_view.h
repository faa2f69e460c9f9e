#pragma once

#include <optional>

#include "terminal/canvas/camera.h"
#include "terminal/draw/draw.h"

/// The player's view of the world: drawing options, camera, and the selected ball.
namespace carom {

struct PlayView {
    ViewOptions options;
    ViewOptions defaults;    ///< of the options, before any key changed them
    Box shown;               ///< what the fitted camera shows: the level with its board
    bool has_board = false;  ///< `shown` ends with a board
    ViewMemory memory;
    Camera camera;
    bool is_fitted = true;     ///< the camera shows the whole scene
    bool shows_whole = false;  ///< pinball: shows the whole table, not the part around the ball
    bool follows = false;      ///< the camera follows the selected ball
    std::optional<BallId> selected;

    /// Finds what the fitted camera shows.
    void measure(const Scene& scene);
    /// The camera that shows all. A board fills the area to its edge: then its rail begins with a
    /// cell, where it would otherwise share one with the ground around it.
    Camera fitted(const CellArea& area, double aspect) const;
    /// Zooms in by `factor`; the world point under `fixed` stays where it is.
    void zoom(CellPoint fixed, double factor);
    void pan(double columns, double rows);
    /// Shows the whole scene. At a pinball table that already is, switches between the whole table
    /// and the part around the ball.
    void fit();
    /// Brings back the default options, and shows the whole scene.
    void reset();
    /// The centre of the camera's area.
    CellPoint middle() const;
};

}  // namespace carom
