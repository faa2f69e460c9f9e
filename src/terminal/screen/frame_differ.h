#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "terminal/canvas/canvas.h"
#include "terminal/screen/cursor.h"
#include "terminal/screen/dialect.h"
#include "terminal/screen/sgr.h"

/// Computes what to send so that a terminal that shows one canvas shows the next.
///
/// ncurses could compute this difference, and did until carom had this class. It was replaced
/// because its cells cannot hold what carom shows: 24-bit colours need a TERM such as xterm-direct,
/// and on Debian 12 octants have no width. Nor does it weigh the bytes of colours, so carom had to
/// parse and rewrite its output. docs/measurements.md compares the two: one write a frame either
/// way, 9 to 40 % fewer bytes, and a half to a fifth of the instructions. ncurses still handles
/// what it is good at: the terminal's description, modes, keys and alternate screen
/// (curses_session.h, terminfo.h).
namespace carom {

/// Remembers what the terminal shows, where its cursor is, and which style is in force. Pure: it
/// only makes bytes; the caller sends them.
class FrameDiffer {
  public:
    explicit FrameDiffer(TerminalDialect dialect = {});

    /// Sets the window size; the next frame sends every cell. Pre: > 0.
    void set_size(int columns, int rows);
    /// The next frame sends every cell and assumes nothing about the terminal's state.
    void redraw() { is_whole_due_ = true; }

    /// The bytes that change the terminal to show `canvas`, valid until the next call; empty where
    /// nothing changes. Cells outside the window are not shown; where the canvas is smaller, the
    /// rest is blank. Cost: one comparison a cell, and some 100 instructions for each changed cell.
    std::string_view paint(const Canvas& canvas);

  private:
    /// The visible part of a cell on this terminal. Cells that look alike are equal: a blank has no
    /// foreground, a block that fills its cell no background.
    struct Look {
        char32_t glyph = U' ';
        SgrStyle style;

        friend bool operator==(const Look&, const Look&) = default;
    };
    /// One way of showing a look, and its cost from the style in force.
    struct Way {
        char32_t glyph = U' ';
        SgrStyle style;
        std::size_t cost = 0;  ///< bytes, including the glyph's
    };
    struct Run {
        int end = 0;          ///< column after the last equal cell
        int last_change = 0;  ///< column after the last changed cell among them
    };

    Look look_of(const Cell& cell) const;
    void begin_whole(const Canvas& canvas);
    void paint_row(const Canvas& canvas, int row);
    void forget_overhang(const Canvas& canvas);
    void reach(int row, int column);
    int paint_blanks(int row, int column);
    int paint_cells(int row, int column);
    const Look& wanted(int column) const { return wanted_[static_cast<std::size_t>(column)]; }
    std::size_t index_of(int row, int column) const;
    int next_change(int row, int column) const;
    Run run_from(int row, int column) const;

    Way way_of(const Look& look, const std::optional<SgrStyle>& style) const;
    std::size_t style_cost(const std::optional<SgrStyle>& from, const SgrStyle& to) const;
    void take_style(const SgrStyle& style);
    void write(const Way& way);

    TerminalDialect dialect_;
    int columns_ = 1;
    int rows_ = 1;
    bool is_whole_due_ = true;
    Canvas canvas_;                      // of the last frame
    std::vector<Look> shown_;            // row by row
    std::vector<Look> wanted_;           // the row being painted
    std::optional<CursorPlace> cursor_;  // none: not known
    std::optional<SgrStyle> style_;      // in force; none: not known
    std::string out_;
};

}  // namespace carom
