#pragma once

#include <vector>

#include "terminal/canvas/canvas.h"

/// Cells of a canvas, handed to ncurses: only those that have changed.
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
    void put_span(const Canvas& canvas, int row, int first, int end, int colors, bool utf8);

    Canvas shown_;
    ColorPairs pairs_;
};

}  // namespace carom
