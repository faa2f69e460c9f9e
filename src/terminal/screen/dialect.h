#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "terminal/canvas/canvas.h"
#include "terminal/screen/sgr.h"

namespace carom {

/// The sequences that a terminal understands, according to its description (terminfo.h). The
/// defaults are xterm's.
struct TerminalDialect {
    int colors = 256;     ///< 0, 8, 16, 256 or direct_colors
    bool is_utf8 = true;  ///< false: everything but ASCII is shown as '?'
    /// The attributes that it has and can combine with colours.
    std::uint8_t attributes = bold | dim | reverse | underline;
    std::uint8_t attributes_in_color = bold | dim | reverse | underline;
    /// SGR 39 and 49 restore the default foreground and background separately.
    bool has_own_colors = true;
    bool erases_in_color = true;  ///< erased cells take the current background
    bool has_erase_line = true;   ///< EL, ESC [ K
    bool has_erase_cells = true;  ///< ECH, ESC [ n X
    bool has_repeat = true;       ///< REP, ESC [ n b; used for ASCII only
    bool has_row = true;          ///< VPA, ESC [ row d
    bool has_column = true;       ///< CHA, ESC [ column G
    /// A block may reach into the cells around it, which are drawn again when it goes.
    bool has_overhang = false;
    /// The cursor stays on a row whose last column has been written. Otherwise it moves on, and in
    /// the last row the screen scrolls, so that corner is left blank.
    bool waits_at_margin = true;
    /// Otherwise the cursor waits in the last cell, where it disturbs least.
    bool hides_cursor = true;
    std::string clear = "\033[H\033[2J";
    /// For terminals that do not understand ECMA-48: the bytes that move to a row and a column
    /// (from 0), and those that set a style from any style. Empty: the terminal uses ECMA-48.
    std::function<std::string(int row, int column)> move;
    std::function<std::string(const SgrStyle&)> style;
};

}  // namespace carom
