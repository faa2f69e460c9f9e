#include "level/values/color_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace carom {
namespace {

struct NamedColor {
    std::string_view name;
    Rgb24 color;
};

// Chosen to be told apart on a dark and on a light board.
constexpr std::array<NamedColor, 26> colors{{
    {"white", 0xf4f1e8},  {"silver", 0xb9c0c8},  {"gray", 0x80868c},    {"grey", 0x80868c},
    {"black", 0x1b1b1f},  {"red", 0xd92b2b},     {"crimson", 0xa3123a}, {"maroon", 0x7a2430},
    {"orange", 0xf08a24}, {"gold", 0xe3b341},    {"yellow", 0xf2d31b},  {"olive", 0x8a8b2c},
    {"lime", 0x9bd83b},   {"green", 0x2f9e44},   {"teal", 0x1b8a8a},    {"cyan", 0x3cc7d6},
    {"sky", 0x7cc4f2},    {"blue", 0x2f6fde},    {"navy", 0x1d2f6f},    {"violet", 0x7b52d3},
    {"purple", 0x8e3fb0}, {"magenta", 0xd63fb4}, {"pink", 0xf08fb4},    {"brown", 0x8a5a33},
    {"tan", 0xcfae7e},    {"wood", 0x7a4a24},
}};

bool is_hex_digit(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

}  // namespace

std::optional<Rgb24> color_named(std::string_view name) {
    const auto found = std::ranges::find(colors, name, &NamedColor::name);
    if (found == colors.end()) return std::nullopt;
    return found->color;
}

std::vector<std::string_view> color_names() {
    std::vector<std::string_view> names;
    for (const NamedColor& color : colors)
        names.push_back(color.name);
    return names;
}

bool is_hex_color(std::string_view text) {
    return text.size() == 7 && text[0] == '#' && std::ranges::all_of(text.substr(1), is_hex_digit);
}

std::optional<Rgb24> color_of(std::string_view text) {
    if (!is_hex_color(text)) return color_named(text);
    Rgb24 color = 0;
    constexpr int hexadecimal = 16;
    std::from_chars(text.data() + 1, text.data() + text.size(), color, hexadecimal);
    return color;
}

std::string color_text(Rgb24 color) {
    return fmt::format("#{:06x}", color);
}

}  // namespace carom
