#include "terminal/canvas/palette.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using namespace carom;

namespace {

constexpr std::array roles = {Role::edge,    Role::zone,     Role::counter, Role::grid,
                              Role::contact, Role::velocity, Role::cue,     Role::selected,
                              Role::cursor,  Role::text,     Role::faint,   Role::strong,
                              Role::good,    Role::warning,  Role::error,   Role::expected};

}  // namespace

TEST_CASE("no colour exceeds the terminal's number of colours") {
    for (const int colors : {0, 2, 8, 16, 256}) {
        for (const bool light : {false, true}) {
            const Look look{colors, true, light};
            const int most = look.has_colors() ? colors : 0;
            const auto fits = [&](const Ink& ink) {
                return ink.color == default_color || (ink.color >= 0 && ink.color < most);
            };
            for (const Role role : roles)
                CHECK(fits(ink_of(role, look)));
            for (std::size_t i = 0; i < 40; ++i) {
                CHECK(fits(ink_of_class(i, look)));
                CHECK(fits(ink_of_material(i, look)));
                const Ink scaled = ink_of_scale(static_cast<double>(i) / 39.0, look);
                CHECK(fits(scaled));
                for (int level = -1; level < 5; ++level) {
                    CHECK(fits({shade(scaled.color, level, look), plain}));
                }
            }
        }
    }
}

TEST_CASE("neighbouring classes have different inks") {
    for (const int colors : {8, 16, 256}) {
        for (const bool light : {false, true}) {
            const Look look{colors, true, light};
            for (std::size_t i = 0; i < 12; ++i)
                CHECK(ink_of_class(i, look) != ink_of_class(i + 1, look));
        }
    }
}

TEST_CASE("the ends of a scale differ, and values outside are clamped") {
    for (const int colors : {0, 8, 16, 256}) {
        const Look look{colors, true, false};
        CHECK(ink_of_scale(0.0, look) != ink_of_scale(1.0, look));
        CHECK(ink_of_scale(-3.0, look) == ink_of_scale(0.0, look));
        CHECK(ink_of_scale(7.0, look) == ink_of_scale(1.0, look));
        CHECK(ink_of_scale(std::nan(""), look) == ink_of_scale(1.0, look));
    }
}

TEST_CASE("shades go from the colour to the background") {
    const Look dark{256, true, false};
    const Look light{256, true, true};
    CHECK(shade(196, 3, dark) == 196);
    CHECK(shade(196, 2, dark) != 196);
    CHECK(shade(231, 0, dark) > 231);  // white becomes a dark grey
    CHECK(shade(16, 0, light) > 231);  // and black, on white, a light one
    CHECK(shade(default_color, 1, dark) == default_color);
    CHECK(shade(9, 1, {16, true, false}) == 9);
}

TEST_CASE("without colour, important roles have attributes") {
    const Look mono{0, true, false};
    for (const Role role : {Role::selected, Role::cue, Role::error, Role::strong}) {
        CHECK(ink_of(role, mono).attributes != plain);
    }
}
