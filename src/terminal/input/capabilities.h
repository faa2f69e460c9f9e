#pragma once

#include <optional>
#include <string_view>

#include "terminal/canvas/color.h"
#include "terminal/canvas/mosaic.h"

/// The abilities of the terminal, according to its description, the environment, and its own
/// answers.
namespace carom {

struct Capabilities {
    int columns = 80;
    int rows = 24;
    int colors = 0;             ///< 0 (none), 8, 16 or 256
    bool direct_color = false;  ///< 24-bit colours are shown exactly
    bool utf8 = false;          ///< false: everything but ASCII is shown as '?'
    double cell_aspect = 2.0;   ///< height of a cell over its width, > 0
    bool light_background = false;
    std::optional<Rgb> background;   ///< its colour; none: the terminal has not told
    Mosaic mosaic = Mosaic::halves;  ///< the finest that the terminal certainly draws
    bool key_release = false;        ///< keys report their release (kitty keyboard protocol)
    bool mouse_pixels = false;       ///< the mouse reports positions finer than a cell
    bool answers = false;            ///< the terminal has answered at least one query
    bool ssh = false;                ///< reached over a network: input may arrive in pieces

    friend bool operator==(const Capabilities&, const Capabilities&) = default;
};

/// Whether the background is light, by COLORFGBG ("15;0", "0;default;15"). None: the value does not
/// say.
std::optional<bool> light_background_from(std::string_view colorfgbg);

/// Height over width of a cell, from the sizes of a window in pixels and in cells; none where a
/// size is missing or makes no sense (a cell of under 2 pixels, or an aspect beyond 1/4 to 8).
std::optional<double> cell_aspect_from(int pixels_wide, int pixels_high, int columns, int rows);

}  // namespace carom
