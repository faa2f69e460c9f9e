#pragma once

#include <optional>
#include <string_view>

#include "terminal/canvas/canvas.h"

/// What the terminal can do, as far as its environment and its own answers tell.
namespace carom {

struct Capabilities {
    int columns = 80;
    int rows = 24;
    int colors = 0;            ///< 0 (none), 8, 16 or 256
    bool utf8 = false;         ///< else everything but ASCII is shown as '?'
    double cell_aspect = 2.0;  ///< height of a cell over its width, > 0
    bool light_background = false;
    bool key_release = false;   ///< keys report that they were let go (kitty keyboard protocol)
    bool mouse_pixels = false;  ///< the mouse is reported finer than a cell
    bool answers = false;       ///< it has answered at least one query
    bool ssh = false;           ///< reached through a network: input may come in pieces

    friend bool operator==(const Capabilities&, const Capabilities&) = default;
};

/// A colour of red, green and blue, each 0..255.
struct Rgb {
    int red = 0;
    int green = 0;
    int blue = 0;

    friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// The colour of xterm's palette of 256. Pre: 0 <= color < 256.
Rgb rgb_of(Color color);

/// Brightness as the eye sees it, 0 (black) to 1 (white).
double luminance(const Rgb& rgb);

/// The number to send to a terminal of `colors` colours for a colour of the palette of 256: the
/// nearest that it has. Negative stays default_color, and so does everything where `colors` < 8.
/// `colors` over 256 means that numbers from 8 up are 0xRRGGBB, as with xterm-direct.
int color_for_terminal(Color color, int colors);

/// COLORFGBG ("15;0", "0;default;15"): whether the background is light. None: it does not say.
std::optional<bool> light_background_from(std::string_view colorfgbg);

/// Height over width of a cell, from the sizes of a window in pixels and in cells; none where a
/// size is missing or makes no sense (a cell of under 2 pixels, or an aspect beyond 1/4 to 8).
std::optional<double> cell_aspect_from(int pixels_wide, int pixels_high, int columns, int rows);

}  // namespace carom
