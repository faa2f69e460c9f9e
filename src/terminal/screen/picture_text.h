#pragma once

#include <string>

#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"

/// Pictures of a canvas as files.
namespace carom {

/// As text with SGR sequences, for `cat`. Every line ends in the terminal's own colours.
std::string ansi_of(const Canvas& canvas);

/// As SVG 1.1: cells of 10 x 20 units. Mosaics, block elements and braille are drawn as shapes, so
/// a viewer needs no font for them; other characters are text in a font of fixed width. Pre:
/// look.has_colors().
std::string svg_of(const Canvas& canvas, const Look& look);

}  // namespace carom
