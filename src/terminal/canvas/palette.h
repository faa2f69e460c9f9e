#pragma once

#include <cstddef>
#include <cstdint>

#include "terminal/canvas/canvas.h"

/// The palette: which colour each part of the picture has, on every kind of terminal.
namespace carom {

/// The abilities of the terminal that decide how things look.
struct Look {
    int colors = 256;  ///< 0 or 2 (none), 8, 16 or 256
    bool utf8 = true;  ///< false: only ASCII is drawn
    bool light_background = false;

    bool has_colors() const { return colors >= 8; }
    friend bool operator==(const Look&, const Look&) = default;
};

/// A colour and its attributes. On terminals with few colours, bold and dim distinguish what
/// colours cannot.
struct Ink {
    Color color = default_color;
    std::uint8_t attributes = plain;

    friend bool operator==(const Ink&, const Ink&) = default;
};

/// Parts of the picture that are not balls.
enum class Role : std::uint8_t {
    edge,
    zone,
    counter,  ///< numbers over bins
    grid,     ///< coordinates and broad-phase cells
    contact,  ///< lines between bodies that collided
    velocity,
    cue,
    selected,
    cursor,
    text,
    faint,   ///< labels of the status line
    strong,  ///< titles
    good,    ///< a check that passes
    warning,
    error,
    expected  ///< a curve of expected values
};

Ink ink_of(Role role, const Look& look);

/// The ink for the kind (or other class) of this number; neighbouring numbers differ most.
Ink ink_of_class(std::size_t number, const Look& look);

/// The ink for edges of the material of this number: quieter than the ink of balls.
Ink ink_of_material(std::size_t number, const Look& look);

/// The ink on a scale from 0 (slow or light) to 1 (fast or heavy). Fractions outside are clamped.
Ink ink_of_scale(double fraction, const Look& look);

/// `color` mixed with the background: level 3 is the colour itself, level 0 is nearly the
/// background. With fewer than 256 colours, the colour itself.
Color shade(Color color, int level, const Look& look);

/// `color` mixed with the background in finer steps: `share` (0 to 1) of the colour. With fewer
/// than 256 colours, the colour itself.
Color dimmed(Color color, double share, const Look& look);

}  // namespace carom
