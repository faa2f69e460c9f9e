#pragma once

#include <string>

#include "terminal/input/keyboard.h"

/// What the terminal's description (terminfo) says. All but is_described() need
/// ncurses to have started.
namespace carom {

/// Whether there is a description of this terminal. (newterm() loses memory over one that is not
/// known.)
bool is_described(const char* term);

/// Whether it has this string, by its short name, such as "cup".
bool has_capability(const char* name);

/// The keys that it names, with what they send.
KeyTable described_keys();

/// Whether each of its own two colours can be had without the other (39 and 49).
bool has_own_colors();

/// What ends all colours and attributes.
std::string plain_style_bytes();

/// What brings the terminal from how ncurses has it back to how it was, its modes aside. `rows`: of
/// the window; the cursor ends up below the last one where there is no other screen to go back to.
std::string farewell_bytes(int rows);

}  // namespace carom
