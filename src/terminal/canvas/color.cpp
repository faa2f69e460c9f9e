#include "terminal/canvas/color.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace carom {
namespace {

// The palette above the first 16: a cube of 6 x 6 x 6 colours, then 24 greys.
constexpr Color first_of_cube = 16;
constexpr Color first_grey = 232;
constexpr std::array<int, 6> cube_steps{0, 95, 135, 175, 215, 255};

// xterm's default values.
constexpr std::array<Rgb, 16> system_colors{{{0, 0, 0},
                                             {205, 0, 0},
                                             {0, 205, 0},
                                             {205, 205, 0},
                                             {0, 0, 238},
                                             {205, 0, 205},
                                             {0, 205, 205},
                                             {229, 229, 229},
                                             {127, 127, 127},
                                             {255, 0, 0},
                                             {0, 255, 0},
                                             {255, 255, 0},
                                             {92, 92, 255},
                                             {255, 0, 255},
                                             {0, 255, 255},
                                             {255, 255, 255}}};

int grey_level(int step) {
    return 8 + 10 * step;
}

int squared_distance(const Rgb& a, const Rgb& b) {
    const auto square = [](int x) { return x * x; };
    return square(a.red - b.red) + square(a.green - b.green) + square(a.blue - b.blue);
}

// The cube is a product of three axes, so the nearest colour in it is the nearest on each axis.
Color nearest_of_palette(const Rgb& rgb) {
    const auto step_of = [](int channel) {
        return channel < 48 ? 0 : channel < 115 ? 1 : (channel - 35) / 40;
    };
    const Color of_cube =
        first_of_cube + 36 * step_of(rgb.red) + 6 * step_of(rgb.green) + step_of(rgb.blue);
    const int mean = (rgb.red + rgb.green + rgb.blue) / 3;
    const Color grey = first_grey + std::clamp((mean - 3) / 10, 0, 23);
    const bool is_grey =
        squared_distance(rgb, rgb_of(grey)) < squared_distance(rgb, rgb_of(of_cube));
    return is_grey ? grey : of_cube;
}

// Keeps the hue, and keeps a dark colour from vanishing into a black background.
Color color_of_eight(const Rgb& rgb) {
    const int most = std::max({rgb.red, rgb.green, rgb.blue});
    if (most < 48) return 0;
    const auto has = [&](int channel) { return 5 * channel >= 3 * most; };
    return (has(rgb.red) ? 1 : 0) + (has(rgb.green) ? 2 : 0) + (has(rgb.blue) ? 4 : 0);
}

Color color_of_sixteen(const Rgb& rgb) {
    constexpr Color grey = 8;
    constexpr Color bright = 8;
    constexpr Color white = 7;
    const Color color = color_of_eight(rgb);
    const int most = std::max({rgb.red, rgb.green, rgb.blue});
    if (color == white && most < 150) return grey;
    return most > 229 && color != 0 ? color + bright : color;
}

}  // namespace

Rgb rgb_of(Color color) {
    if (is_direct(color)) return {color >> 16 & 255, color >> 8 & 255, color & 255};
    if (color < first_of_cube) return system_colors[static_cast<std::size_t>(std::max(0, color))];
    if (color >= first_grey) {
        const int level = grey_level(std::min(color, 255) - first_grey);
        return {level, level, level};
    }
    const int place = color - first_of_cube;
    const auto step = [](int n) { return cube_steps[static_cast<std::size_t>(n)]; };
    return {step(place / 36), step(place / 6 % 6), step(place % 6)};
}

double luminance(const Rgb& rgb) {
    return (0.299 * rgb.red + 0.587 * rgb.green + 0.114 * rgb.blue) / 255.0;
}

Color color_for_terminal(Color color, int colors) {
    if (color < 0 || colors < 8) return default_color;
    if (colors >= direct_colors) return color;
    if (colors >= 256) return is_direct(color) ? nearest_of_palette(rgb_of(color)) : color;
    if (colors >= 16) return color < 16 ? color : color_of_sixteen(rgb_of(color));
    constexpr Color grey = 8;
    constexpr Color white = 7;
    if (color < 8) return color;
    if (color < 16) return color == grey ? white : color - 8;
    return color_of_eight(rgb_of(color));
}

}  // namespace carom
