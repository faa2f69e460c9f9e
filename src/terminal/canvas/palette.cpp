#include "terminal/canvas/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace carom {

namespace {

// The difference in hue and saturation: the distance of the colours after their grey part is
// removed.
int tint_error(const Rgb& a, const Rgb& b) {
    const int red = a.red - b.red;
    const int green = a.green - b.green;
    const int blue = a.blue - b.blue;
    const int grey = (red + green + blue) / 3;
    const auto square = [](int x) { return x * x; };
    return square(red - grey) + square(green - grey) + square(blue - grey);
}

// `tint_weight`: how much more an error in hue counts than one in brightness.
Color nearest_color(const Rgb& wanted, int tint_weight) {
    const auto square = [](int x) { return x * x; };
    constexpr int first_of_cube = 16;  // terminal themes change the colours below
    int nearest = first_of_cube;
    int least = std::numeric_limits<int>::max();
    for (int color = first_of_cube; color < 256; ++color) {
        const Rgb have = rgb_of(color);
        const int error = square(have.red - wanted.red) + square(have.green - wanted.green) +
                          square(have.blue - wanted.blue) + tint_weight * tint_error(have, wanted);
        if (error < least) {
            least = error;
            nearest = color;
        }
    }
    return static_cast<Color>(nearest);
}

// The colour mixed with the background, black or white.
Color mixed(int color, int percent, bool light_background, int tint_weight) {
    const Rgb full = rgb_of(color);
    const int white = light_background ? 255 * (100 - percent) : 0;
    const auto mix = [&](int channel) { return (channel * percent + white) / 100; };
    return nearest_color({mix(full.red), mix(full.green), mix(full.blue)}, tint_weight);
}

using ShadeTable = std::array<std::array<Color, 3>, 256>;

ShadeTable make_shades(bool light_background) {
    constexpr std::array<int, 3> percent = {22, 48, 74};
    ShadeTable table{};
    for (int color = 0; color < 256; ++color) {
        for (std::size_t level = 0; level < 3; ++level)
            table[static_cast<std::size_t>(color)][level] =
                mixed(color, percent[level], light_background, 0);
    }
    return table;
}

// From the background to the full colour.
constexpr int fade_steps = 10;
// The weight is high because neighbouring steps of another hue would look like another ball.
constexpr int fade_tint_weight = 6;
using FadeTable = std::array<std::array<Color, fade_steps + 1>, 256>;

FadeTable make_fades(bool light_background) {
    FadeTable table{};
    for (int color = 0; color < 256; ++color)
        for (int step = 0; step <= fade_steps; ++step)
            table[static_cast<std::size_t>(color)][static_cast<std::size_t>(step)] =
                mixed(color, 100 * step / fade_steps, light_background, fade_tint_weight);
    return table;
}

// A role's colour on each kind of terminal. With few colours, bold and dim tell roles apart.
struct RoleInk {
    Color dark_256;
    Color light_256;
    Color dark_16;
    Color light_16;
    Color of_8;
    std::uint8_t attributes;       ///< on a terminal with colours
    std::uint8_t mono_attributes;  ///< on a terminal without
};

RoleInk role_ink(Role role) {
    switch (role) {
        case Role::edge:
            return {248, 240, 7, 8, default_color, plain, plain};
        case Role::zone:
            return {240, 250, 8, 7, 6, plain, plain};
        case Role::counter:
            return {229, 94, 11, 3, 3, plain, bold};
        case Role::grid:
            return {237, 253, 8, 7, 4, plain, dim};
        case Role::contact:
            return {196, 160, 9, 1, 1, bold, bold};
        case Role::velocity:
            return {120, 28, 10, 2, 2, plain, plain};
        case Role::cue:
            return {222, 130, 11, 3, 3, bold, bold};
        case Role::selected:
            return {231, 16, 15, 0, default_color, bold, bold};
        case Role::cursor:
            return {231, 16, 15, 0, default_color, bold, bold};
        case Role::text:
            return {default_color, default_color, default_color, default_color,
                    default_color, plain,         plain};
        case Role::faint:
            return {244, 245, 8, 8, default_color, plain, plain};
        case Role::strong:
            return {231, 16, 15, 0, default_color, bold, bold};
        case Role::good:
            return {114, 28, 10, 2, 2, plain, plain};
        case Role::warning:
            return {221, 130, 11, 3, 3, plain, bold};
        case Role::error:
            return {203, 160, 9, 1, 1, bold, reverse};
        case Role::expected:
            return {215, 166, 11, 1, 3, bold, bold};
    }
    return {};
}

// Orange, blue, green, pink, yellow, cyan, red, violet and white, then darker shades of these.
constexpr std::array<Color, 14> classes_256_dark = {215, 75,  120, 211, 228, 87,  203,
                                                    141, 255, 179, 68,  71,  168, 37};
constexpr std::array<Color, 14> classes_256_light = {166, 26, 28, 162, 136, 30,  160,
                                                     92,  16, 94, 61,  22,  125, 23};
constexpr std::array<Color, 8> classes_16_dark = {11, 14, 10, 13, 9, 12, 15, 3};
constexpr std::array<Color, 8> classes_16_light = {1, 4, 2, 5, 3, 6, 0, 9};
constexpr std::array<Color, 6> classes_8 = {3, 6, 2, 5, 1, 4};

constexpr std::array<Color, 9> scale_256_dark = {69, 75, 80, 84, 155, 227, 221, 215, 203};
constexpr std::array<Color, 9> scale_256_light = {19, 26, 30, 29, 64, 100, 136, 166, 160};
constexpr std::array<Color, 5> scale_16_dark = {12, 14, 10, 11, 9};
constexpr std::array<Color, 5> scale_16_light = {4, 6, 2, 3, 1};
constexpr std::array<Color, 4> scale_8 = {6, 2, 3, 1};

template <std::size_t count>
Color nth(const std::array<Color, count>& colors, std::size_t number) {
    return colors[number % count];
}

template <std::size_t count>
Color along(const std::array<Color, count>& colors, double fraction) {
    const double place = fraction * static_cast<double>(count);
    return colors[std::min(static_cast<std::size_t>(place), count - 1)];
}

}  // namespace

Ink ink_of(Role role, const Look& look) {
    const RoleInk ink = role_ink(role);
    if (!look.has_colors()) return {default_color, ink.mono_attributes};
    if (look.colors < 16) return {ink.of_8, ink.attributes};
    if (look.colors < 256) {
        return {look.light_background ? ink.light_16 : ink.dark_16, ink.attributes};
    }
    return {look.light_background ? ink.light_256 : ink.dark_256, ink.attributes};
}

Ink ink_of_class(std::size_t number, const Look& look) {
    if (!look.has_colors()) return {};
    if (look.colors < 16) {
        // The second time through the colours, bold makes the difference.
        const bool is_second = number / classes_8.size() % 2 == 1;
        return {nth(classes_8, number), is_second ? bold : plain};
    }
    if (look.colors < 256) {
        return {nth(look.light_background ? classes_16_light : classes_16_dark, number), plain};
    }
    return {nth(look.light_background ? classes_256_light : classes_256_dark, number), plain};
}

Ink ink_of_scale(double fraction, const Look& look) {
    const double place = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 1.0;
    if (!look.has_colors()) return {default_color, place > 0.6 ? bold : plain};
    if (look.colors < 16) return {along(scale_8, place), plain};
    if (look.colors < 256) {
        return {along(look.light_background ? scale_16_light : scale_16_dark, place), plain};
    }
    return {along(look.light_background ? scale_256_light : scale_256_dark, place), plain};
}

Ink ink_of_material(std::size_t number, const Look& look) {
    constexpr std::array<Color, 6> dark = {248, 180, 110, 139, 108, 144};
    constexpr std::array<Color, 6> light = {240, 94, 60, 96, 65, 101};
    constexpr std::array<Color, 4> of_16_dark = {7, 3, 6, 5};
    constexpr std::array<Color, 4> of_16_light = {8, 3, 6, 5};
    if (!look.has_colors() || look.colors < 16) return ink_of(Role::edge, look);
    if (look.colors < 256) {
        return {nth(look.light_background ? of_16_light : of_16_dark, number), plain};
    }
    return {nth(look.light_background ? light : dark, number), plain};
}

Color shade(Color color, int level, const Look& look) {
    static const std::array<ShadeTable, 2> tables = {make_shades(false), make_shades(true)};
    if (look.colors < 256 || level >= 3 || color < 0 || color > 255) return color;
    const ShadeTable& table = tables[look.light_background ? 1 : 0];
    return table[static_cast<std::size_t>(color)][static_cast<std::size_t>(std::max(level, 0))];
}

Color dimmed(Color color, double share, const Look& look) {
    static const std::array<FadeTable, 2> tables = {make_fades(false), make_fades(true)};
    if (look.colors < 256 || !(share < 1.0) || color < 0 || color > 255) return color;
    const auto step = static_cast<std::size_t>(std::max(0.0, share) * fade_steps + 0.5);
    return tables[look.light_background ? 1 : 0][static_cast<std::size_t>(color)][step];
}

}  // namespace carom
