#include "terminal/screen/environment.h"

#include <langinfo.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <clocale>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "terminal/input/capabilities.h"

namespace carom {
namespace {

std::string variable(const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr ? value : "";
}

// Sets the locale's character set. A locale that is named but not installed, as often over SSH,
// still tells what the terminal understands.
bool is_utf8_locale() {
    if (std::setlocale(LC_CTYPE, "") == nullptr) {
        std::string named = variable("LC_ALL");
        if (named.empty()) named = variable("LC_CTYPE");
        if (named.empty()) named = variable("LANG");
        const bool is_utf8 = named.ends_with("UTF-8") || named.ends_with("utf8");
        if (is_utf8) std::setlocale(LC_CTYPE, "C.UTF-8");
    }
    return std::string_view(nl_langinfo(CODESET)) == "UTF-8";
}

}  // namespace

std::string described_terminal(const Variables& variables) {
    constexpr std::array signs = {"XTERM_VERSION", "VTE_VERSION", "COLORTERM"};
    const std::string named = variables("TERM");
    const bool has_256 =
        std::ranges::any_of(signs, [&](const char* sign) { return !variables(sign).empty(); });
    return named == "xterm" && has_256 ? "xterm-256color" : named;
}

bool has_direct_colors(const Variables& variables) {
    const std::string promise = variables("COLORTERM");
    return (promise == "truecolor" || promise == "24bit") &&
           !variables("TERM").starts_with("screen");
}

int cells_from(std::string_view text) {
    int cells = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, cells);
    return fault == std::errc{} && stop == end ? std::max(cells, 0) : 0;
}

TerminalEnvironment read_terminal_environment() {
    TerminalEnvironment environment;
    environment.terminal = described_terminal(variable);
    environment.is_utf8 = is_utf8_locale();
    environment.is_ssh = !variable("SSH_CONNECTION").empty() || !variable("SSH_TTY").empty();
    environment.is_light = light_background_from(variable("COLORFGBG")).value_or(false);
    environment.wants_no_colors = !variable("NO_COLOR").empty();
    environment.has_direct_colors = has_direct_colors(variable);
    environment.columns = cells_from(variable("COLUMNS"));
    environment.rows = cells_from(variable("LINES"));
    return environment;
}

}  // namespace carom
