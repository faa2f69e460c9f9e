#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "terminal/canvas/canvas.h"
#include "terminal/canvas/mosaic.h"
#include "terminal/canvas/theme.h"

/// The palette: which colour each part of the picture has, on every kind of terminal. The colours
/// are the theme's (theme.h). A terminal with 24-bit colour shows them exactly, one of 256 colours
/// the nearest it has; of 16 or 8 colours each part gets the nearest that differs from the others
/// of its group and from the background.
namespace carom {

/// The abilities of the terminal that decide how things look.
struct Look {
    int colors = 256;  ///< 0 or 2 (none), 8, 16, 256 or direct_colors
    bool utf8 = true;  ///< false: only ASCII is drawn
    bool light_background = false;
    Mosaic mosaic = Mosaic::halves;  ///< the finest that the terminal shows without gaps
    ThemeName theme = ThemeName::standard;
    std::optional<Rgb> ground;  ///< the terminal's background; none: not known

    bool has_colors() const { return colors >= 8; }
    /// Colours can be mixed: there are enough of them for shades.
    bool has_shades() const { return colors >= 256; }
    friend bool operator==(const Look&, const Look&) = default;
};

/// A colour and its attributes. On terminals with few colours, bold and dim distinguish what
/// colours cannot.
struct Ink {
    Color color = default_color;
    std::uint8_t attributes = plain;

    friend bool operator==(const Ink&, const Ink&) = default;
};

Ink ink_of(Role role, const Look& look);

/// The ink for the kind (or other class) of this number; neighbouring numbers differ most.
Ink ink_of_class(std::size_t number, const Look& look);

/// The ink for edges of the material of this number: quieter than the ink of balls.
Ink ink_of_material(std::size_t number, const Look& look);

/// The ink on a scale from 0 (slow or light) to 1 (fast or heavy). Fractions outside are clamped.
Ink ink_of_scale(double fraction, const Look& look);

/// The ink of a pool ball: 0 the cue ball, 1 to 15; a stripe has that of the solid 8 before it.
/// Pre: number >= 0.
Ink ink_of_pool_ball(int number, const Look& look);

/// The ink of a colour that an author chose.
Ink ink_of_color(const Rgb& rgb, const Look& look);

/// Of a terminal with few colours: the one with the hue nearest to that of `rgb`, for a pattern
/// that lets the background through. Pre: look.has_colors().
Color color_of_hue(const Rgb& rgb, const Look& look);

/// Black or white: what can be read on `color`. default_color for default_color.
Color text_color_on(Color color, const Look& look);
/// text_color_on() in bold, except black, which many terminals with few colours show as grey when
/// it is bold.
Ink strong_text_on(Color color, const Look& look);

/// The background's colour, as far as it is known, and the colour of text on it. Pre:
/// look.has_colors().
Color ground_color(const Look& look);
Color foreground_color(const Look& look);

/// A share (0 to 1) of `over` on `ground`, either of which may be default_color (the background),
/// as a colour that the terminal has. Without shades: the one of which there is more.
Color blended(Color over, Color ground, double share, const Look& look);

/// `color` mixed with a ground, or with the background: `share` (0 to 1) of the colour. Without
/// shades, the colour.
Color dimmed(Color color, double share, Color ground, const Look& look);
inline Color dimmed(Color color, double share, const Look& look) {
    return dimmed(color, share, ground_color(look), look);
}

/// The colours of a lit ball, from its shadow to its highlight. Without shades, all are `color`.
struct Tones {
    Color shadow = default_color;
    Color base = default_color;
    Color light = default_color;
    Color glint = default_color;
};
Tones tones_of(Color color, const Look& look);

}  // namespace carom
