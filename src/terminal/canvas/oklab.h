#pragma once

#include "terminal/canvas/color.h"

/// OKLab, a colour space in which distances are what the eye sees (Björn Ottosson, 2020,
/// https://bottosson.github.io/posts/oklab). Colours are designed and compared in it.
namespace carom {

/// Lightness 0 (black) to 1 (white); a from green to red, b from blue to yellow, about -0.4 to 0.4.
struct Lab {
    double lightness = 0.0;
    double a = 0.0;
    double b = 0.0;
};

/// The same space in polar form: chroma is 0 for greys and about 0.3 at most; hue in degrees: red
/// 29, yellow 110, green 142, cyan 195, blue 264, magenta 328.
struct Lch {
    double lightness = 0.0;
    double chroma = 0.0;
    double hue = 0.0;
};

Lab lab_of(const Rgb& rgb);
Lab lab_of(const Lch& lch);

/// The colour; where a screen cannot show one so vivid, the most vivid one of that lightness and
/// hue.
Rgb rgb_of(const Lch& lch);
Rgb rgb_of(const Lab& lab);

/// The square of the distance: below 0.0004 two colours look alike.
double squared_distance(const Lab& a, const Lab& b);

/// How wrong `shown` is in place of `wanted` on a terminal of so many colours. A wrong hue disturbs
/// more than a wrong lightness, the more so the fewer colours there are: a dark green becomes a
/// green rather than a grey, and a grey white rather than cyan.
double reduction_error(const Lab& shown, const Lab& wanted, int colors);

}  // namespace carom
