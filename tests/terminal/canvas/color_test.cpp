#include "terminal/canvas/color.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>

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

TEST_CASE("a colour stays itself if the terminal has it, and otherwise keeps its hue") {
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
    CHECK(color_for_terminal(208, direct_colors) == 208);
}

TEST_CASE("a 24-bit colour is shown exactly, or as the nearest available one") {
    const Color orange = direct_color({250, 130, 5});
    CHECK(is_direct(orange));
    CHECK(rgb_of(orange) == Rgb{250, 130, 5});
    CHECK(color_for_terminal(orange, direct_colors) == orange);
    CHECK(color_for_terminal(orange, 256) == 208);
    CHECK(color_for_terminal(orange, 16) == 9);
    CHECK(color_for_terminal(orange, 8) == 1);
    CHECK(color_for_terminal(orange, 0) == default_color);
    CHECK(rgb_of(direct_color({0, 0, 0})) == Rgb{0, 0, 0});
    CHECK_FALSE(is_direct(default_color));
    CHECK_FALSE(is_direct(255));
}

TEST_CASE("the nearest colour of the cube and the greys is chosen") {
    const auto distance = [](const Rgb& a, const Rgb& b) {
        const auto square = [](int x) { return x * x; };
        return square(a.red - b.red) + square(a.green - b.green) + square(a.blue - b.blue);
    };
    std::uint32_t state = 1;
    for (int i = 0; i < 3000; ++i) {
        state = state * 1664525u + 1013904223u;
        const Rgb rgb{static_cast<int>(state >> 24), static_cast<int>(state >> 16 & 255),
                      static_cast<int>(state >> 8 & 255)};
        const Color taken = color_for_terminal(direct_color(rgb), 256);
        int least = 1 << 20;
        for (Color color = 16; color < 256; ++color)
            least = std::min(least, distance(rgb, rgb_of(color)));
        CHECK(distance(rgb, rgb_of(taken)) == least);
    }
}
