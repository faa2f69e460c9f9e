#include "terminal/canvas/legible.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "terminal/canvas/oklab.h"

namespace carom {

namespace {

// Lighter ground takes dark text.
constexpr double middle = 0.6;

Color make_legible(Color ink, Color ground, double contrast, int colors) {
    Lab text = lab_of(rgb_of(ink));
    const double below = lab_of(rgb_of(ground)).lightness;
    if (std::abs(text.lightness - below) >= contrast) return ink;
    text.lightness = std::clamp(below < middle ? below + contrast : below - contrast, 0.0, 1.0);
    return color_for_terminal(direct_color(rgb_of(text)), colors);
}

}  // namespace

Color legible_on(Color ink, Color ground, const Look& look, double contrast) {
    if (!look.has_shades() || ink < 0 || ground < 0) return ink;
    struct Known {
        Color ink = default_color;
        Color ground = default_color;
        double contrast = 0.0;
        int colors = 0;
        Color legible = default_color;
    };
    thread_local std::array<Known, 256> cache;
    const auto hash = static_cast<std::uint32_t>(ink) * 2654435761u ^
                      static_cast<std::uint32_t>(ground) * 2246822519u;
    Known& known = cache[hash >> 24];
    if (known.ink != ink || known.ground != ground || known.contrast != contrast ||
        known.colors != look.colors)
        known = {ink, ground, contrast, look.colors,
                 make_legible(ink, ground, contrast, look.colors)};
    return known.legible;
}

}  // namespace carom
