#include <cmath>

#include "terminal/draw/draw_parts.h"

/// Draws, over the bodies, what the player points at and does.
namespace carom {

namespace {

// Dots along a line, `spacing` columns apart.
void paint_dots(Raster& raster, RasterPoint from, RasterPoint to, double spacing, const Ink& ink) {
    const double dx = to.x - from.x;
    const double dy = to.y - from.y;
    const double length = std::sqrt(dx * dx + dy * dy);
    constexpr double most = 2000.0;  // longer lines leave the window
    if (!(length <= most)) return;
    for (double along = spacing; along < length; along += spacing) {
        const double share = along / length;
        raster.disc({from.x + share * dx, from.y + share * dy}, 0.0, 0.0, {ink, 255, '\0'});
    }
}

}  // namespace

void paint_annotations(Raster& raster, const View& view) {
    const Annotations& annotations = view.annotations;
    const Look& look = view.options.look;
    const Ink cue_ink = ink_of(Role::cue, look);
    for (std::size_t i = 1; i < annotations.path.size(); ++i) {
        paint_dots(raster, to_raster(view.camera, annotations.path[i - 1]),
                   to_raster(view.camera, annotations.path[i]), 1.5, cue_ink);
    }
    if (annotations.cue) {
        const RasterPoint ball = to_raster(view.camera, annotations.cue->ball);
        const RasterPoint hand = to_raster(view.camera, annotations.cue->hand);
        raster.line(ball, hand, cue_ink);
        // The ball goes the opposite way.
        paint_dots(raster, ball, {2.0 * ball.x - hand.x, 2.0 * ball.y - hand.y}, 1.5, cue_ink);
    }
    if (annotations.new_capsule) {
        const Capsule& shape = *annotations.new_capsule;
        raster.capsule(to_raster(view.camera, shape.start), to_raster(view.camera, shape.end),
                       shape.radius * view.camera.columns_per_length,
                       {ink_of(Role::selected, look), 255, '#'});
    }
}

}  // namespace carom
