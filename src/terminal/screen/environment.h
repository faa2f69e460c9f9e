#pragma once

#include <functional>
#include <string>
#include <string_view>

/// What the environment variables say about the terminal.
namespace carom {

struct TerminalEnvironment {
    std::string terminal;  ///< the name of the terminfo description; empty: none is named
    bool is_utf8 = false;
    bool is_ssh = false;
    bool is_light = false;           ///< the background is light, by COLORFGBG
    bool wants_no_colors = false;    ///< NO_COLOR
    bool has_direct_colors = false;  ///< shows 24-bit colours, by COLORTERM
    int columns = 0;                 ///< COLUMNS and LINES; 0: not set, or no size
    int rows = 0;
};

/// Also sets the locale's character set (LC_CTYPE).
TerminalEnvironment read_terminal_environment();

/// The value of a variable, empty where it is not set.
using Variables = std::function<std::string(const char* name)>;

/// Whether COLORTERM promises 24-bit colours. GNU screen inherits the promise without keeping it,
/// so it does not count.
bool has_direct_colors(const Variables& variables);

/// A size in cells from a variable's text; 0 if it is none.
int cells_from(std::string_view text);

/// The name of the terminfo description to use: TERM, but xterm-256color for a terminal that sets
/// TERM to xterm (8 colours) while another variable shows that it has 256.
std::string described_terminal(const Variables& variables);

}  // namespace carom
