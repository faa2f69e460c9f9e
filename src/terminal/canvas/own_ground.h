#pragma once

#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"

/// A theme for the other kind of background, a light one in a dark terminal, brings its own.
namespace carom {

/// Gives cells that have the terminal's own colours those of the theme: its ground, and its colour
/// of text. Without colours it does nothing.
void paint_own_ground(Canvas& canvas, const Look& look);

}  // namespace carom
