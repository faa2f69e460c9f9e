#pragma once

#include <vector>

#include "terminal/canvas.h"

/// Cells of a canvas, handed to ncurses: only those that have changed, and so that the terminal
/// needs few changes of colour.
namespace carom {

/// The numbers that ncurses gives to pairs of colours, handed out as they come up.
class ColorPairs {
  public:
    ColorPairs();
    /// The pair for two colours of the palette of 256, or default_color, on a terminal of so many.
    /// When all pairs are in use: that of the foreground alone, else 0, the terminal's own colours.
    int number(Color foreground, Color background, int colors);

  private:
    int& slot(int foreground, int background);

    std::vector<int> pairs_;
    int next_ = 1;
};

/// Knows what ncurses has in each cell of its window.
class CursesCells {
  public:
    bool has_shape_of(const Canvas& canvas) const;
    /// The window is blank, and what comes next has this canvas' shape.
    void forget(const Canvas& canvas);
    /// Pre: has_shape_of(canvas). `colors`: of the terminal, 0 for none.
    void put(const Canvas& canvas, int colors, bool utf8);

  private:
    /// How ncurses shows a cell.
    struct Style {
        unsigned attributes = 0;  // of ncurses
        int pair = 0;
        bool shows_on_blanks = false;  // a blank in this style does not look like a blank
    };
    Style style_of(const Cell& cell, int colors);
    Style& style_at(int column, int row);
    void put_span(const Canvas& canvas, int row, int first, int end, int colors, bool utf8);

    Canvas shown_;
    std::vector<Style> styles_;  // row by row
    Style pen_;                  // of the last cell that changed in this frame
    ColorPairs pairs_;
};

}  // namespace carom
