#pragma once

#include <string_view>

#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"

/// Digits and commas of several rows, that can be read across a room. Other characters are blank.
namespace carom {

/// The columns of a text at scale 1.
int large_width(std::string_view text);
/// The rows of a digit at scale 1: half as many where blocks halve a cell.
int large_rows(const Look& look);

void write_large(Canvas& canvas, int column, int row, std::string_view text, int scale,
                 const Ink& ink, const Look& look);

/// Writes a count into the upper right corner of `area`, twice as large in a roomy one; nothing
/// where it would take half of the area's width or height.
void draw_large_count(Canvas& canvas, const CellArea& area, std::string_view count,
                      const Look& look);

}  // namespace carom
