#pragma once

#include <string_view>

/// A typical terminal font (DejaVu Sans Mono), to show how characters look without a screen.
namespace carom::test {

inline constexpr int font_columns = 8;  ///< pixels in a cell
inline constexpr int font_rows = 16;

/// The ink of a pixel of a printable ASCII character, 0 to 1. Pre: x and y within the cell.
double font_ink(char glyph, int x, int y);

}  // namespace carom::test
