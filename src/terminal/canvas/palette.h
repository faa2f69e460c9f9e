#pragma once

#include <cstddef>
#include <cstdint>

#include "terminal/canvas/canvas.h"

/// Which colours stand for what, on every kind of terminal.
namespace carom {

/// What the terminal can show.
struct Look {
    int colors = 256;  ///< 0 or 2 (none), 8, 16 or 256
    bool utf8 = true;  ///< else nothing but ASCII is drawn
    bool light_background = false;

    bool has_colors() const { return colors >= 8; }
    friend bool operator==(const Look&, const Look&) = default;
};

/// A colour and the attributes that go with it: where there are few colours, bold and dim tell
/// apart what colours cannot.
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
    contact,  ///< lines between what met
    velocity,
    cue,
    selected,
    cursor,
    text,
    faint,   ///< labels of the status line
    strong,  ///< titles
    good,    ///< a check that holds
    warning,
    error,
    expected  ///< a curve to compare with
};

Ink ink_of(Role role, const Look& look);

/// For the kind (or any other class) of this number; neighbours in number differ most.
Ink ink_of_class(std::size_t number, const Look& look);

/// For edges of the material of this number: quieter than balls.
Ink ink_of_material(std::size_t number, const Look& look);

/// Along a scale: 0 is slow or light, 1 is fast or heavy. Outside: the nearer end.
Ink ink_of_scale(double fraction, const Look& look);

/// `color` mixed with the background: 3 is the colour itself, 0 almost nothing left. Without 256
/// colours always the colour itself.
Color shade(Color color, int level, const Look& look);

/// Mixes a colour with the background in finer steps: `share` (0 to 1) of the colour. Without 256
/// colours always the colour itself.
Color dimmed(Color color, double share, const Look& look);

}  // namespace carom
