#include "terminal/input/capabilities.h"

#include <algorithm>
#include <array>

namespace carom {
namespace {

constexpr std::array<Rgb, 16> first_colors{{{0, 0, 0},
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
constexpr Color cube_start = 16;
constexpr Color greys_start = 232;

// A colour keeps its hue; a dark one must not vanish into a black background.
int color_of_eight(const Rgb& rgb) {
    const int most = std::max({rgb.red, rgb.green, rgb.blue});
    if (most < 48) return 0;
    const auto has = [&](int channel) { return 5 * channel >= 3 * most; };
    return (has(rgb.red) ? 1 : 0) + (has(rgb.green) ? 2 : 0) + (has(rgb.blue) ? 4 : 0);
}

int color_of_sixteen(const Rgb& rgb) {
    constexpr int grey = 8;
    constexpr int bright = 8;
    constexpr int white = 7;
    const int color = color_of_eight(rgb);
    const int most = std::max({rgb.red, rgb.green, rgb.blue});
    if (color == white && most < 150) return grey;
    return most > 229 && color != 0 ? color + bright : color;
}

}  // namespace

Rgb rgb_of(Color color) {
    if (color < cube_start) return first_colors[static_cast<std::size_t>(std::max<int>(0, color))];
    if (color >= greys_start) {
        const int level = 8 + 10 * (std::min<int>(color, 255) - greys_start);
        return {level, level, level};
    }
    const auto channel = [](int step) { return step == 0 ? 0 : 55 + 40 * step; };
    const int number = color - cube_start;
    return {channel(number / 36), channel(number / 6 % 6), channel(number % 6)};
}

double luminance(const Rgb& rgb) {
    return (0.299 * rgb.red + 0.587 * rgb.green + 0.114 * rgb.blue) / 255.0;
}

int color_for_terminal(Color color, int colors) {
    if (color < 0 || colors < 8) return default_color;
    if (colors > 256) {  // the first eight are the palette's there too
        const Rgb rgb = rgb_of(color);
        return color < 8 ? color : rgb.red << 16 | rgb.green << 8 | rgb.blue;
    }
    if (colors == 256) return std::min<int>(color, 255);
    if (colors >= 16) return color < 16 ? color : color_of_sixteen(rgb_of(color));
    constexpr Color grey = 8;
    constexpr Color white = 7;
    if (color < 8) return color;
    if (color < 16) return color == grey ? white : color - 8;
    return color_of_eight(rgb_of(color));
}

std::optional<bool> light_background_from(std::string_view colorfgbg) {
    const std::size_t cut = colorfgbg.rfind(';');
    if (cut == std::string_view::npos) return std::nullopt;
    const std::string_view background = colorfgbg.substr(cut + 1);
    const bool is_number = !background.empty() && background.size() <= 2 &&
                           background.find_first_not_of("0123456789") == std::string_view::npos;
    if (!is_number) return std::nullopt;
    int number = 0;
    for (const char digit : background) {
        number = 10 * number + (digit - '0');
    }
    if (number > 15) return std::nullopt;
    return number == 7 || number > 8;
}

std::optional<double> cell_aspect_from(int pixels_wide, int pixels_high, int columns, int rows) {
    if (columns <= 0 || rows <= 0) return std::nullopt;
    // A window is not always a whole number of cells.
    const int wide = pixels_wide / columns;
    const int high = pixels_high / rows;
    if (wide < 2 || high < 2 || high > 8 * wide || wide > 4 * high) return std::nullopt;
    return static_cast<double>(high) / wide;
}

}  // namespace carom
