#include "terminal/input/capabilities.h"

#include <doctest/doctest.h>

using namespace carom;

TEST_CASE("the palette of 256 is xterm's") {
    CHECK(rgb_of(9) == Rgb{255, 0, 0});
    CHECK(rgb_of(16) == Rgb{0, 0, 0});
    CHECK(rgb_of(196) == Rgb{255, 0, 0});
    CHECK(rgb_of(67) == Rgb{95, 135, 175});
    CHECK(rgb_of(231) == Rgb{255, 255, 255});
    CHECK(rgb_of(232) == Rgb{8, 8, 8});
    CHECK(rgb_of(255) == Rgb{238, 238, 238});
}

TEST_CASE("a colour stays itself where the terminal has it, and keeps its hue where it has not") {
    for (Color color = 0; color < 256; ++color) {
        CHECK(color_for_terminal(color, 256) == color);
        CHECK(color_for_terminal(color, 0) == default_color);
        const int of_eight = color_for_terminal(color, 8);
        CHECK(of_eight >= 0);
        CHECK(of_eight < 8);
        const int of_sixteen = color_for_terminal(color, 16);
        CHECK(of_sixteen >= 0);
        CHECK(of_sixteen < 16);
        if (color < 16) CHECK(of_sixteen == color);
        if (luminance(rgb_of(color)) > 0.25) CHECK(of_eight != 0);
    }
    CHECK(color_for_terminal(default_color, 256) == default_color);
    CHECK(color_for_terminal(196, 8) == 1);
    CHECK(color_for_terminal(196, 16) == 9);
    CHECK(color_for_terminal(17, 8) == 4);  // a dark blue is blue, not black
    CHECK(color_for_terminal(244, 8) == 7);
    CHECK(color_for_terminal(240, 16) == 8);
    CHECK(color_for_terminal(8, 8) == 7);
    CHECK(color_for_terminal(208, 1 << 24) == 0xff8700);
    CHECK(color_for_terminal(5, 1 << 24) == 5);
}

TEST_CASE("COLORFGBG") {
    CHECK(light_background_from("15;0") == false);
    CHECK(light_background_from("0;15") == true);
    CHECK(light_background_from("0;default;15") == true);
    CHECK(light_background_from("15;8") == false);
    CHECK(light_background_from("0;7") == true);
    for (const auto text : {"", "7", "15;default", "15;", "0;99", "0;x", "0;-1"}) {
        CHECK_FALSE(light_background_from(text));
    }
}

TEST_CASE("the aspect of a cell, from whole pixels") {
    CHECK(cell_aspect_from(800, 480, 80, 24) == 2.0);
    CHECK(cell_aspect_from(725, 360, 80, 24) == doctest::Approx(15.0 / 9.0));  // padding is no cell
    CHECK_FALSE(cell_aspect_from(0, 0, 80, 24));
    CHECK_FALSE(cell_aspect_from(800, 480, 0, 0));
    CHECK_FALSE(cell_aspect_from(80, 24, 80, 24));
    CHECK_FALSE(cell_aspect_from(160, 4800, 80, 24));
}
