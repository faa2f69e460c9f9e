#include "terminal/canvas/surface_colors.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "terminal/canvas/oklab.h"

using namespace carom;

namespace {

Look look_with(int colors) {
    Look look;
    look.colors = colors;
    return look;
}

double degrees_apart(const Rgb& a, const Rgb& b) {
    const Lab first = lab_of(a);
    const Lab second = lab_of(b);
    const double turn = std::atan2(first.a * second.b - first.b * second.a,
                                   first.a * second.a + first.b * second.b);
    return std::abs(turn) * 180.0 / 3.14159265358979;
}

double chroma(const Rgb& rgb) {
    const Lab lab = lab_of(rgb);
    return std::hypot(lab.a, lab.b);
}

constexpr Rgb felt{26, 107, 72};
constexpr Rgb rail{92, 58, 24};
constexpr Rgb nose{33, 139, 93};
constexpr Rgb chalk{66, 129, 97};

}  // namespace

TEST_CASE("surfaces: of 256 colours felt stays green and a wooden rail brown") {
    const std::array wanted{felt, rail};
    const std::vector<Color> colors = surface_colors(wanted, {}, look_with(256));
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        CAPTURE(i);
        CHECK(degrees_apart(rgb_of(colors[i]), wanted[i]) < 30.0);
        CHECK(chroma(rgb_of(colors[i])) > 0.06);
    }
    // The nearest colours by distance alone are teal and grey.
    const Look look = look_with(256);
    CHECK(degrees_apart(rgb_of(ink_of_color(felt, look).color), felt) > 30.0);
    CHECK(chroma(rgb_of(ink_of_color(rail, look).color)) < 0.02);
}

TEST_CASE("surfaces: a line on felt does not vanish in it, nor a cushion's nose") {
    const std::array wanted{felt, nose, chalk};
    const std::array neighbours{Neighbours{0, 1}, Neighbours{0, 2}};
    const std::vector<Color> colors = surface_colors(wanted, neighbours, look_with(256));
    CHECK(colors[1] != colors[0]);
    CHECK(colors[2] != colors[0]);
    const double lightness = lab_of(rgb_of(colors[0])).lightness;
    CHECK(lab_of(rgb_of(colors[1])).lightness > lightness);
    CHECK(lab_of(rgb_of(colors[2])).lightness > lightness);
}

TEST_CASE("surfaces: what is nearly grey stays so, and 24-bit colours are as they are") {
    const std::array wanted{Rgb{32, 38, 46}, Rgb{232, 226, 208}};
    for (const Color color : surface_colors(wanted, {}, look_with(256)))
        CHECK(chroma(rgb_of(color)) < 0.04);
    const std::vector<Color> exact = surface_colors(wanted, {}, look_with(direct_colors));
    CHECK(exact[0] == direct_color(wanted[0]));
    for (const int few : {8, 16})
        for (const Color color : surface_colors(wanted, {}, look_with(few)))
            CHECK(color < few);
}

TEST_CASE("surfaces: a fairway is no teal, and a lane of pale wood no bright orange") {
    // Of mini-golf's windmill: the board, the fairway, and the ring around the hole.
    const std::array golf{felt, Rgb{46, 125, 67}, Rgb{52, 138, 75}};
    const std::array greens{Neighbours{0, 1}, Neighbours{1, 2}};
    const std::vector<Color> shown = surface_colors(golf, greens, look_with(256));
    CHECK(degrees_apart(rgb_of(shown[1]), golf[1]) < 10.0);
    CHECK(shown[2] != shown[1]);
    // Of skittles: the lane, and what lies around it.
    const std::array skittles{Rgb{185, 138, 82}, Rgb{138, 103, 61}, Rgb{122, 74, 36}};
    const std::array woods{Neighbours{0, 1}, Neighbours{1, 2}};
    const std::vector<Color> lane = surface_colors(skittles, woods, look_with(256));
    CHECK(chroma(rgb_of(lane[0])) < 1.2 * chroma(skittles[0]));
}

TEST_CASE("surfaces: two dark areas do not become a dark and a pale one") {
    // Of night-vault: the board, the rings around the bumpers, the arrow.
    const std::array wanted{Rgb{28, 26, 46}, Rgb{40, 34, 74}, Rgb{53, 44, 99}, Rgb{36, 32, 64}};
    const std::array neighbours{Neighbours{0, 1}, Neighbours{1, 2}, Neighbours{0, 3}};
    const std::vector<Color> shown = surface_colors(wanted, neighbours, look_with(256));
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        CAPTURE(i);
        CHECK(lab_of(rgb_of(shown[i])).lightness < lab_of(wanted[i]).lightness + 0.1);
    }
}
