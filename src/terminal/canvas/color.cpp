#include "terminal/canvas/color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "terminal/canvas/oklab.h"

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

// The palette in OKLab, except default_color.
std::array<Lab, 256> make_lab_palette() {
    std::array<Lab, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = lab_of(rgb_of(static_cast<Color>(i)));
    return table;
}

Color nearest_of_palette(const Rgb& rgb, Color first, Color last) {
    static const std::array<Lab, 256> palette = make_lab_palette();
    const Lab wanted = lab_of(rgb);
    Color nearest = first;
    double least = 1e9;
    for (Color color = first; color <= last; ++color) {
        const double error =
            reduction_error(palette[static_cast<std::size_t>(color)], wanted, last + 1);
        if (error >= least) continue;
        least = error;
        nearest = color;
    }
    return nearest;
}

// A cache with one entry for each hash of a colour: pictures use few colours, many times.
struct Found {
    Color color = default_color;
    Color nearest = default_color;
};
constexpr std::size_t cache_size = 4096;

Color remembered_nearest(Color color, Color first, Color last,
                         std::array<Found, cache_size>& cache) {
    const auto bits = static_cast<std::uint32_t>(color);
    Found& found = cache[(bits * 2654435761u) >> 20];
    if (found.color != color) found = {color, nearest_of_palette(rgb_of(color), first, last)};
    return found.nearest;
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

Color mixed(Color over, Color ground, double share) {
    const Rgb top = rgb_of(over);
    const Rgb bottom = rgb_of(ground);
    // Squares of the channels are nearly proportional to light.
    const auto mix = [&](int a, int b) {
        return static_cast<int>(std::sqrt(share * a * a + (1.0 - share) * b * b) + 0.5);
    };
    return direct_color(
        {mix(top.red, bottom.red), mix(top.green, bottom.green), mix(top.blue, bottom.blue)});
}

Color color_for_terminal(Color color, int colors) {
    if (color < 0 || colors < 8) return default_color;
    if (colors >= direct_colors) return color;
    const Color last = colors >= 256 ? 255 : colors >= 16 ? 15 : 7;
    if (color <= last) return color;
    const Color first = colors >= 256 ? first_of_cube : 0;
    thread_local std::array<std::array<Found, cache_size>, 3> caches;
    return remembered_nearest(color, first, last, caches[last == 255 ? 2 : last == 15 ? 1 : 0]);
}

}  // namespace carom
