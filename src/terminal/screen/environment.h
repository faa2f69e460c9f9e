#pragma once

#include <functional>
#include <string>

/// What the process' environment says about the terminal that it runs in.
namespace carom {

struct TerminalEnvironment {
    std::string terminal;  ///< the name of its description; empty: none is named
    bool is_utf8 = false;
    bool is_ssh = false;
    bool is_light = false;           ///< its background, by COLORFGBG
    bool wants_no_colors = false;    ///< NO_COLOR
    bool has_direct_colors = false;  ///< shows 24-bit colours, by COLORTERM
};

/// Sets the locale's characters as well.
TerminalEnvironment read_terminal_environment();

/// The value of a variable, empty where it is not set.
using Variables = std::function<std::string(const char* name)>;

/// Whether COLORTERM promises 24-bit colours. GNU screen inherits the promise and does not keep it.
bool has_direct_colors(const Variables& variables);

/// The description to use. Many terminals call themselves xterm, which promises 8 colours, and say
/// elsewhere that they have 256: those get xterm's of 256.
std::string described_terminal(const Variables& variables);

}  // namespace carom
