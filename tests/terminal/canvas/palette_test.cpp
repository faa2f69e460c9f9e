#include "terminal/canvas/palette.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string_view>
#include <vector>

using namespace carom;

namespace {

std::vector<Role> every_role() {
    std::vector<Role> roles;
    for (std::size_t i = 0; i < role_count; ++i)
        roles.push_back(static_cast<Role>(i));
    return roles;
}

// Every kind of terminal, background and theme.
std::vector<Look> every_look() {
    std::vector<Look> looks;
    for (const int colors : {0, 2, 8, 16, 256, direct_colors})
        for (const bool light : {false, true})
            for (const ThemeName theme :
                 {ThemeName::standard, ThemeName::contrast, ThemeName::color_blind})
                looks.push_back({.colors = colors, .light_background = light, .theme = theme});
    return looks;
}

double lightness(Color color) {
    return lab_of(rgb_of(color)).lightness;
}

// As a person without the cones for long or for medium waves sees it (Viénot, Brettel and Mollon,
// 1999; nearly the same for both): red and green become one.
Lab without_red_and_green(Color color) {
    const Rgb rgb = rgb_of(color);
    const double yellow = 0.2 * rgb.red + 0.8 * rgb.green;
    const int mixed = static_cast<int>(yellow);
    return lab_of(Rgb{mixed, mixed, rgb.blue});
}

}  // namespace

TEST_CASE("no colour exceeds the terminal's number of colours") {
    for (const Look& look : every_look()) {
        const int most = look.has_colors() ? look.colors : 0;
        const auto fits = [&](const Ink& ink) {
            return color_for_terminal(ink.color, most) == ink.color;
        };
        for (const Role role : every_role())
            CHECK(fits(ink_of(role, look)));
        for (std::size_t i = 0; i < 40; ++i) {
            CHECK(fits(ink_of_class(i, look)));
            CHECK(fits(ink_of_material(i, look)));
            CHECK(fits(ink_of_pool_ball(static_cast<int>(i), look)));
            CHECK(fits(ink_of_color({static_cast<int>(i), 100, 200}, look)));
            const Ink scaled = ink_of_scale(static_cast<double>(i) / 39.0, look);
            CHECK(fits(scaled));
            CHECK(fits({dimmed(scaled.color, static_cast<double>(i) / 39.0, look), plain}));
            CHECK(fits({tones_of(scaled.color, look).light, plain}));
        }
    }
}

TEST_CASE("neighbouring classes have different inks") {
    for (const Look& look : every_look()) {
        if (!look.has_colors()) continue;
        for (std::size_t i = 0; i < 12; ++i)
            CHECK(ink_of_class(i, look) != ink_of_class(i + 1, look));
    }
}

TEST_CASE("the ends of a scale differ, and values outside are clamped") {
    for (const Look& look : every_look()) {
        CHECK(ink_of_scale(0.0, look) != ink_of_scale(1.0, look));
        CHECK(ink_of_scale(-3.0, look) == ink_of_scale(0.0, look));
        CHECK(ink_of_scale(7.0, look) == ink_of_scale(1.0, look));
        CHECK(ink_of_scale(std::nan(""), look) == ink_of_scale(1.0, look));
    }
}

TEST_CASE("everything can be told from the background") {
    for (const Look& look : every_look()) {
        if (!look.has_colors()) continue;
        const double behind = look.light_background ? 1.0 : 0.0;
        const auto is_seen = [&](const Ink& ink, double least) {
            return ink.color < 0 || std::abs(lightness(ink.color) - behind) >= least;
        };
        for (const Role role : every_role())
            if (role != Role::cloth && role != Role::grid && role != Role::zone &&
                role != Role::stripe_white)
                CHECK(is_seen(ink_of(role, look), 0.22));
        for (std::size_t i = 0; i < 14; ++i) {
            CHECK(is_seen(ink_of_class(i, look), 0.22));
            CHECK(is_seen(ink_of_material(i, look), 0.22));
        }
    }
}

TEST_CASE("the scale changes its lightness steadily, so that it reads without hues") {
    for (const Look& look : every_look()) {
        if (!look.has_shades()) continue;
        const double direction = look.light_background ? -1.0 : 1.0;
        for (int i = 0; i < 11; ++i) {
            const double here = lightness(ink_of_scale(i / 11.0, look).color);
            const double next = lightness(ink_of_scale((i + 1) / 11.0, look).color);
            // The nearest of 256 colours may be a little off.
            CHECK(direction * (next - here) > (look.colors == 256 ? -0.08 : 0.01));
        }
    }
}

TEST_CASE("the colour-blind theme is told apart without red and green") {
    for (const bool light : {false, true}) {
        const Look look{
            .colors = direct_colors, .light_background = light, .theme = ThemeName::color_blind};
        for (std::size_t i = 0; i < 8; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                CAPTURE(light);
                CAPTURE(i);
                CAPTURE(j);
                CHECK(squared_distance(without_red_and_green(ink_of_class(i, look).color),
                                       without_red_and_green(ink_of_class(j, look).color)) >
                      0.0025);
            }
        }
    }
}

TEST_CASE("a pool ball has a colour of its own, also where there are only 8") {
    for (const Look& look : every_look()) {
        if (!look.has_colors()) continue;
        for (int i = 0; i < 9; ++i)
            for (int j = 0; j < i; ++j)
                CHECK(ink_of_pool_ball(i, look) != ink_of_pool_ball(j, look));
        CHECK(ink_of_pool_ball(11, look) == ink_of_pool_ball(3, look));
    }
}

TEST_CASE("dimming goes from the background to the colour") {
    const Look dark{};
    const Look light{.light_background = true};
    CHECK(dimmed(196, 1.0, dark) == 196);
    CHECK(dimmed(196, 0.7, dark) != 196);
    CHECK(lightness(dimmed(231, 0.2, dark)) < 0.5);
    CHECK(lightness(dimmed(16, 0.2, light)) > 0.5);
    CHECK(dimmed(default_color, 0.3, dark) == default_color);
    CHECK(dimmed(9, 0.3, {.colors = 16}) == 9);
}

TEST_CASE("a ball is darker in its shadow and brighter in its light") {
    for (const int colors : {256, direct_colors}) {
        const Look look{.colors = colors};
        for (std::size_t i = 0; i < 14; ++i) {
            const Tones tones = tones_of(ink_of_class(i, look).color, look);
            CHECK(lightness(tones.shadow) < lightness(tones.base));
            CHECK(lightness(tones.base) <= lightness(tones.light));
            CHECK(lightness(tones.light) <= lightness(tones.glint));
        }
    }
    const Tones flat = tones_of(3, {.colors = 16});
    CHECK(flat.shadow == 3);
    CHECK(flat.glint == 3);
}

TEST_CASE("text on a colour is black or white, whichever is legible") {
    CHECK(rgb_of(text_color_on(226, {})) == Rgb{0, 0, 0});
    CHECK(rgb_of(text_color_on(18, {})) == Rgb{255, 255, 255});
    CHECK(text_color_on(4, {.colors = 8}) == 7);
    CHECK(text_color_on(3, {.colors = 8}) == 0);
    // Bold black would be grey.
    CHECK(strong_text_on(3, {.colors = 8}).attributes == plain);
    CHECK(strong_text_on(4, {.colors = 8}).attributes == bold);
    CHECK(strong_text_on(226, {}).attributes == bold);
}

TEST_CASE("a theme is chosen by name") {
    for (const std::string_view name : theme_choice_names())
        CHECK(theme_choice(name));
    CHECK(theme_choice("light") == ThemeChoice{ThemeName::standard, true});
    CHECK(theme_choice("auto") == ThemeChoice{});
    CHECK_FALSE(theme_choice("solarized"));
}

TEST_CASE("without colour, important roles have attributes") {
    const Look mono{0, true, false};
    for (const Role role : {Role::selected, Role::cue, Role::error, Role::strong}) {
        CHECK(ink_of(role, mono).attributes != plain);
    }
}
