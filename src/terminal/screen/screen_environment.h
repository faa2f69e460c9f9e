#pragma once

#include <functional>
#include <string>

/// What the process' environment says about the terminal that it runs in.
namespace carom {

struct ScreenEnvironment {
    std::string terminal;  ///< the name of its description; empty: none is named
    bool is_utf8 = false;
    bool is_ssh = false;
    bool is_light = false;         ///< its background, by COLORFGBG
    bool wants_no_colors = false;  ///< NO_COLOR
};

/// Sets the locale's characters as well.
ScreenEnvironment read_screen_environment();

/// The value of a variable, empty where it is not set.
using Variables = std::function<std::string(const char* name)>;

/// The description to use. Many terminals call themselves xterm, which promises 8 colours, and say
/// elsewhere that they have 256: those get xterm's of 256.
std::string described_terminal(const Variables& variables);

}  // namespace carom
