#include "terminal/canvas/own_ground.h"

#include <doctest/doctest.h>

using namespace carom;

TEST_CASE("a theme that brings its own ground gives it to cells with the terminal's colours") {
    Look look{.colors = direct_colors, .light_background = true};
    Canvas canvas(3, 1);
    canvas.put(0, 0, {U'a'});
    canvas.put(1, 0, {U'b', 1, 2});
    paint_own_ground(canvas, look);
    CHECK(canvas.at(0, 0) == Cell{U'a', foreground_color(look), ground_color(look)});
    CHECK(canvas.at(1, 0) == Cell{U'b', 1, 2});
    CHECK(canvas.at(2, 0).background == ground_color(look));
    CHECK(luminance(rgb_of(ground_color(look))) > luminance(rgb_of(foreground_color(look))));

    look.colors = 0;
    Canvas plain(1, 1);
    paint_own_ground(plain, look);
    CHECK(plain.at(0, 0) == Cell{});
}
