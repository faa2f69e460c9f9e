#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"

/// Text in a part of the canvas: the building blocks of panels and pages.
namespace carom {

/// A few words that are kept together on a line.
struct PanelText {
    std::string text;
    Ink ink;
};

/// The first `columns` columns of UTF-8 text.
std::string_view cut_to(std::string_view text, int columns);

/// Text that is too long ends at a word, with an ellipsis, so that it does not read as a fault.
/// Where not even a word fits, it is cut.
std::string shortened(std::string_view text, int columns, const Look& look);

/// Writes into row `row` of the area, cut at its right edge. A row outside the area is ignored.
void write_cut(Canvas& canvas, const CellArea& area, int row, std::string_view text,
               const Ink& ink);

/// The number of rows that the texts take in so many columns, two blanks between them; at least 1.
int rows_for(std::span<const PanelText> texts, int columns);
/// Writes as many of the texts as fit.
void write_flowing(Canvas& canvas, const CellArea& area, std::span<const PanelText> texts);

/// The ends of the axes of a graph: their labels.
struct AxisEnds {
    std::string low;  ///< of the vertical axis
    std::string high;
    std::string from;  ///< of the horizontal axis
    std::string to;
};
/// Writes the labels of a graph. The first row of `area` has its title. The labels of the vertical
/// axis go to its left, those of the horizontal axis below it; `to` is left out where it does not
/// fit. Returns the area of the graph itself.
CellArea draw_axes(Canvas& canvas, const CellArea& area, const AxisEnds& ends, const Look& look);

/// Breaks text at blanks so that no line is longer than `columns`; a longer word is cut. A number
/// and its unit, such as "3 s", stay together.
std::vector<std::string> wrapped(std::string_view text, int columns);

}  // namespace carom
