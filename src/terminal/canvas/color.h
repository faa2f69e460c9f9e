#pragma once

#include <cstdint>

/// Colours of cells, and how terminals with fewer colours show them.
namespace carom {

/// One of three: default_color; an index into xterm's 256-colour palette (0 to 255); or 24 bits of
/// red, green and blue, made by direct_color().
using Color = std::int32_t;

/// The terminal's own foreground or background.
inline constexpr Color default_color = -1;

/// The number of colours of a terminal with 24-bit colour.
inline constexpr int direct_colors = 1 << 24;

/// Red, green and blue, each 0 to 255.
struct Rgb {
    int red = 0;
    int green = 0;
    int blue = 0;

    friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// Pre: each channel is 0 to 255.
constexpr Color direct_color(const Rgb& rgb) {
    return direct_colors | rgb.red << 16 | rgb.green << 8 | rgb.blue;
}
constexpr bool is_direct(Color color) {
    return color >= direct_colors;
}

/// Red, green and blue of a colour, according to xterm's palette. A terminal theme may change the
/// first 16. Pre: color != default_color.
Rgb rgb_of(Color color);

/// Perceived brightness, 0 (black) to 1 (white).
double luminance(const Rgb& rgb);

/// A share (0 to 1) of `over`, the rest of `ground`: the light of both, as an eye sees a cell that
/// they divide. Neither may be default_color.
Color mixed(Color over, Color ground, double share);

/// The colour that a terminal of `colors` colours (8, 16, 256 or direct_colors) has and that looks
/// most like `color`: itself where it can be shown, else a palette index. Of 256 only the last 240,
/// whose values are known. default_color stays itself; with fewer than 8 colours every colour
/// becomes default_color. Remembers what it found, so it costs a look-up.
Color color_for_terminal(Color color, int colors);

}  // namespace carom
