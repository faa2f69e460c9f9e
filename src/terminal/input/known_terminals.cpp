#include "terminal/input/known_terminals.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace carom {
namespace {

struct Version {
    int major = 0;
    int minor = 0;

    friend auto operator<=>(const Version&, const Version&) = default;
};

struct KnownTerminal {
    std::string_view name;
    Version since;
    TerminalTraits traits;
};

// Per terminal the newest version first. Sources: the change logs of the terminals. VTE counts
// 0.78.0 as 7800; WezTerm counts days.
constexpr std::array known = std::to_array<KnownTerminal>({
    {"kitty", {0, 40}, {Mosaic::octants, true}},
    {"kitty", {0, 21}, {Mosaic::sextants, true}},
    {"ghostty", {1, 2}, {Mosaic::octants, true}},
    {"ghostty", {1, 0}, {Mosaic::sextants, true}},
    {"foot", {1, 20}, {Mosaic::octants, true}},
    {"foot", {1, 13}, {Mosaic::sextants, true}},
    {"vte", {7800, 0}, {Mosaic::octants, true}},
    {"vte", {6600, 0}, {Mosaic::sextants, true}},
    {"wezterm", {20220101, 0}, {Mosaic::sextants, true}},
    {"contour", {0, 3}, {Mosaic::sextants, true}},
    {"konsole", {20, 0}, {Mosaic::halves, true}},
    {"iterm2", {3, 0}, {Mosaic::halves, true}},
    {"xterm", {0, 0}, {Mosaic::halves, false, true}},
});

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool starts_with_name(std::string_view text, std::string_view name) {
    if (text.size() < name.size()) return false;
    return std::equal(name.begin(), name.end(), text.begin(),
                      [](char a, char b) { return a == lower(b); });
}

int number_at(std::string_view& text) {
    int number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc{}) return 0;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

// "(0.40.1)" or " 1.2.0" after the name.
Version version_in(std::string_view text) {
    if (text.empty() || (text.front() != '(' && text.front() != ' ')) return {};
    text.remove_prefix(1);
    Version version;
    version.major = number_at(text);
    if (text.starts_with('.')) {
        text.remove_prefix(1);
        version.minor = number_at(text);
    }
    return version;
}

}  // namespace

TerminalTraits traits_of(std::string_view version) {
    for (const KnownTerminal& terminal : known) {
        if (!starts_with_name(version, terminal.name)) continue;
        if (version_in(version.substr(terminal.name.size())) >= terminal.since)
            return terminal.traits;
    }
    return {};
}

}  // namespace carom
