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

/// What to send so that a terminal that shows one canvas shows another.
///
/// ncurses could compute this difference, and did until carom had this class. It was replaced
/// because its cells cannot hold what carom shows: 24-bit colours need a TERM such as xterm-direct,
/// and on Debian 12 octants have no width. Nor does it weigh the bytes of colours, so what it wrote
/// was parsed and rewritten. docs/measurements.md compares the two: one write a frame either way, 9
/// to 40 % fewer bytes, and a half to a fifth of the instructions. ncurses keeps what it is good
/// at: the terminal's description, modes, keys and other screen (curses_session.h, terminfo.h).
namespace carom {

/// Remembers what the terminal shows, where its cursor is, and which style is in force. Pure: it
/// makes the bytes, others send them.
class FrameDiffer {
  public:
    explicit FrameDiffer(TerminalDialect dialect = {});

    /// From the next frame on the window has this size, and everything is sent. Pre: > 0.
    void set_size(int columns, int rows);
    /// The next frame sends everything: whatever is shown, wherever the cursor is.
    void redraw() { is_whole_due_ = true; }

    /// The bytes, valid until the next call; empty where nothing is to change. Cells outside the
    /// window are not shown; where the canvas is smaller, the rest is blank. Cost: a comparison a
    /// cell, and some 100 instructions for each that has changed.
    std::string_view paint(const Canvas& canvas);

  private:
    /// What is to be seen of a cell on this terminal. Cells that look the same are equal: a blank
    /// has no foreground, a block that fills its cell no background.
    struct Look {
        char32_t glyph = U' ';
        SgrStyle style;

        friend bool operator==(const Look&, const Look&) = default;
    };
    /// One way of showing a look, and what it takes from the style in force.
    struct Way {
        char32_t glyph = U' ';
        SgrStyle style;
        std::size_t cost = 0;  ///< bytes, the glyph's included
    };
    struct Run {
        int end = 0;          ///< column behind the last equal cell
        int last_change = 0;  ///< column behind the last of them that is to change
    };

    Look look_of(const Cell& cell) const;
    void begin_whole(const Canvas& canvas);
    void paint_row(const Canvas& canvas, int row);
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
    std::vector<Look> wanted_;           // the row in hand
    std::optional<CursorPlace> cursor_;  // none: not known
    std::optional<SgrStyle> style_;      // in force; none: not known
    std::string out_;
};

}  // namespace carom
