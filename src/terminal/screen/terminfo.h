#pragma once

#include <string>

#include "terminal/input/keyboard.h"
#include "terminal/screen/frame_differ.h"

/// What the terminal's description (terminfo) says. All but is_described() need a CursesSession to
/// have started.
namespace carom {

/// Whether there is a description of this terminal. (newterm() leaks memory over an unknown one.)
bool is_described(const char* term);

/// Whether it has this string, by its short name, such as "cup".
bool has_capability(const char* name);

/// Whether this is an emulator of today, which may be asked questions.
bool is_modern_emulator();

/// The keys that it names, with what they send.
KeyTable described_keys();

/// How frames are written to it. `most_colors`: 0 to direct_colors; the result has as many of them
/// as the description says, but direct_colors counts whatever it says, since hardly any description
/// knows 24-bit colours. A terminal that does not understand ECMA-48 gets the description's own
/// strings, for every style and every movement.
TerminalDialect described_dialect(int most_colors, bool is_utf8);

/// The number of colours; over 256 where colours have 24 bits, as with xterm-direct. Below 8: none.
int described_colors();

/// What ends all colours and attributes.
std::string plain_style_bytes();

/// What brings the terminal from how ncurses has it back to how it was, its modes aside. `rows`: of
/// the window; where there is no other screen to leave, the cursor ends up below the last row.
std::string farewell_bytes(int rows);

}  // namespace carom
