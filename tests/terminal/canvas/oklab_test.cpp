#include "terminal/canvas/oklab.h"

#include <doctest/doctest.h>

using namespace carom;

TEST_CASE("the primary colours have their published places in OKLab") {
    const Lab white = lab_of(Rgb{255, 255, 255});
    CHECK(white.lightness == doctest::Approx(1.0).epsilon(1e-4));
    CHECK(white.a == doctest::Approx(0.0).epsilon(1e-4));
    const Lab red = lab_of(Rgb{255, 0, 0});
    CHECK(red.lightness == doctest::Approx(0.62796).epsilon(1e-4));
    CHECK(red.a == doctest::Approx(0.22486).epsilon(1e-3));
    CHECK(red.b == doctest::Approx(0.12585).epsilon(1e-3));
    const Lab blue = lab_of(Rgb{0, 0, 255});
    CHECK(blue.lightness == doctest::Approx(0.45201).epsilon(1e-4));
    CHECK(blue.b == doctest::Approx(-0.31153).epsilon(1e-3));
}

TEST_CASE("colours survive the way to OKLab and back") {
    for (int red = 0; red < 256; red += 15)
        for (int green = 0; green < 256; green += 15)
            for (int blue = 0; blue < 256; blue += 15)
                CHECK(rgb_of(lab_of(Rgb{red, green, blue})) == Rgb{red, green, blue});
}

TEST_CASE("a colour too vivid for a screen keeps its lightness and its hue") {
    const Lch wanted{0.8, 0.5, 30.0};
    const Lab shown = lab_of(rgb_of(wanted));
    CHECK(shown.lightness == doctest::Approx(0.8).epsilon(0.01));
    CHECK(shown.b / shown.a == doctest::Approx(0.577).epsilon(0.05));
}
