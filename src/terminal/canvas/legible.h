#pragma once

#include "terminal/canvas/palette.h"

/// Text that can be read on coloured ground.
namespace carom {

/// `ink`, made lighter on dark ground and darker on light ground as far as text needs to be read
/// on it; the hue stays. Where the terminal has no shades, or either is default_color: `ink`.
/// Remembers what it found, so it costs a look-up.
Color legible_on(Color ink, Color ground, const Look& look);

}  // namespace carom
