#pragma once

#include "terminal/canvas/palette.h"

/// Text that can be read on coloured ground.
namespace carom {

/// A difference of OKLab's lightness. Dark red on dark blue has 0.1, and is unreadable.
inline constexpr double text_contrast = 0.25;

/// `ink`, made lighter on dark ground and darker on light ground as far as text needs to be read
/// on it: until its lightness differs by `contrast`. The hue stays. Where the terminal has no
/// shades, or either is default_color: `ink`. Remembers what it found, so it costs a look-up.
Color legible_on(Color ink, Color ground, const Look& look, double contrast = text_contrast);

}  // namespace carom
