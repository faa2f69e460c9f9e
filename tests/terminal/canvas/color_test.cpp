#include "terminal/canvas/color.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>

#include "terminal/canvas/oklab.h"

using namespace carom;

TEST_CASE("the palette of 256 colours is xterm's") {
    CHECK(rgb_of(9) == Rgb{255, 0, 0});
    CHECK(rgb_of(16) == Rgb{0, 0, 0});
    CHECK(rgb_of(196) == Rgb{255, 0, 0});
    CHECK(rgb_of(67) == Rgb{95, 135, 175});
    CHECK(rgb_of(231) == Rgb{255, 255, 255});
    CHECK(rgb_of(232) == Rgb{8, 8, 8});
    CHECK(rgb_of(255) == Rgb{238, 238, 238});
}

TEST_CASE("a colour stays itself if the terminal has it, and otherwise becomes the nearest") {
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
        if (luminance(rgb_of(color)) > 0.45) CHECK(of_eight != 0);
    }
    CHECK(color_for_terminal(default_color, 256) == default_color);
    CHECK(color_for_terminal(196, 8) == 1);
    CHECK(color_for_terminal(196, 16) == 9);
    CHECK(color_for_terminal(17, 8) == 4);  // a dark blue is blue, not black
    CHECK(color_for_terminal(244, 8) == 7);
    CHECK(color_for_terminal(240, 16) == 8);
    CHECK(color_for_terminal(22, 256) == 22);
    CHECK(color_for_terminal(208, direct_colors) == 208);
}

TEST_CASE("a 24-bit colour is shown exactly, or as the nearest available one") {
    const Color orange = direct_color({250, 130, 5});
    CHECK(is_direct(orange));
    CHECK(rgb_of(orange) == Rgb{250, 130, 5});
    CHECK(color_for_terminal(orange, direct_colors) == orange);
    CHECK(color_for_terminal(orange, 256) == 208);
    CHECK(color_for_terminal(orange, 16) == 9);
    CHECK(color_for_terminal(orange, 8) == 1);  // red, the nearest hue
    CHECK(color_for_terminal(orange, 0) == default_color);
    CHECK(rgb_of(direct_color({0, 0, 0})) == Rgb{0, 0, 0});
    CHECK_FALSE(is_direct(default_color));
    CHECK_FALSE(is_direct(255));
}

TEST_CASE("of 256 colours the one that looks nearest is chosen, hue before lightness") {
    std::uint32_t state = 1;
    for (int i = 0; i < 300; ++i) {
        state = state * 1664525u + 1013904223u;
        const Rgb rgb{static_cast<int>(state >> 24), static_cast<int>(state >> 16 & 255),
                      static_cast<int>(state >> 8 & 255)};
        const Color taken = color_for_terminal(direct_color(rgb), 256);
        REQUIRE(taken >= 16);  // terminals have themes of their own for the others
        for (Color color = 16; color < 256; ++color) {
            // No other is nearer in both respects.
            const Lab wanted = lab_of(rgb);
            const Lab other = lab_of(rgb_of(color));
            const Lab have = lab_of(rgb_of(taken));
            const auto tint = [&](const Lab& lab) {
                return std::hypot(lab.a - wanted.a, lab.b - wanted.b);
            };
            const auto light = [&](const Lab& lab) {
                return std::abs(lab.lightness - wanted.lightness);
            };
            CHECK_FALSE((tint(other) < tint(have) - 1e-9 && light(other) < light(have) - 1e-9));
        }
    }
    CHECK(color_for_terminal(direct_color({20, 75, 30}), 256) == 22);  // a green cloth, not a grey
}

TEST_CASE("a mixture lies between its colours, and has the light of both") {
    const Color red = direct_color({255, 0, 0});
    const Color blue = direct_color({0, 0, 255});
    CHECK(mixed(red, blue, 1.0) == red);
    CHECK(mixed(red, blue, 0.0) == blue);
    CHECK(mixed(red, blue, 0.5) == direct_color({180, 0, 180}));
    CHECK(mixed(231, 16, 0.25) == direct_color({128, 128, 128}));
}
