#pragma once

#include <string>

#include "terminal/input/keyboard.h"
#include "terminal/screen/frame_differ.h"

/// Reads the terminal's description (terminfo). All functions but is_described() need a
/// CursesSession that has started.
namespace carom {

/// Whether a description of this terminal exists. (Calling newterm() for an unknown one leaks
/// memory.)
bool is_described(const char* term);

/// Whether the description has this string, by its short name, such as "cup".
bool has_capability(const char* name);

/// Whether this is a modern emulator, which may be sent queries.
bool is_modern_emulator();

/// The keys in the description, with the sequences that they send.
KeyTable described_keys();

/// How to write frames to this terminal. `most_colors`: 0 to direct_colors. The result has at most
/// as many colours as the description says, except that direct_colors is always honoured, since
/// hardly any description knows 24-bit colours, and `promised_colors`, since the terminal itself
/// said that it has them. A terminal that does not understand ECMA-48 gets the description's own
/// strings, for every style and every movement.
TerminalDialect described_dialect(int most_colors, bool is_utf8, int promised_colors = 0);

/// The number of colours; over 256 where colours have 24 bits, as with xterm-direct. Below 8: none.
int described_colors();

/// The bytes that reset all colours and attributes.
std::string plain_style_bytes();

/// The bytes that bring the terminal back from the state ncurses left it in, its modes aside.
/// `rows`: of the window; without an alternate screen to leave, the cursor ends up below the last
/// row.
std::string farewell_bytes(int rows);

}  // namespace carom
