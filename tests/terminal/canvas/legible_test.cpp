#include "terminal/canvas/legible.h"

#include <doctest/doctest.h>

#include <cmath>

#include "terminal/canvas/oklab.h"

using namespace carom;

TEST_CASE("legible: dark red on dark blue becomes lighter, and what can be read stays") {
    Look look;
    look.colors = direct_colors;
    const Color ground = direct_color({22, 32, 58});
    const Color dark_red = direct_color({80, 10, 20});
    const auto lightness = [](Color color) { return lab_of(rgb_of(color)).lightness; };
    const Color shown = legible_on(dark_red, ground, look);
    CHECK(lightness(shown) - lightness(ground) > 0.2);
    CHECK(lab_of(rgb_of(shown)).a > 0.05);  // still red
    const Color white = direct_color({250, 250, 250});
    CHECK(legible_on(white, ground, look) == white);
    CHECK(legible_on(default_color, ground, look) == default_color);
    CHECK(legible_on(dark_red, default_color, look) == dark_red);
    const Color pale = direct_color({220, 220, 180});
    CHECK(lightness(legible_on(white, pale, look)) < lightness(pale));
    look.colors = 8;
    CHECK(legible_on(1, 4, look) == 1);
}
