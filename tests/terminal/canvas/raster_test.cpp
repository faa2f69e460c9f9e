#include "terminal/canvas/raster.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

using namespace carom;

namespace {

constexpr Brush solid{{}, 255, '\0'};

// The painted area, in square columns.
double painted(const Raster& raster) {
    double sum = 0.0;
    for (int down = 0; down < raster.samples_down(); ++down) {
        for (int across = 0; across < raster.samples_across(); ++across) {
            sum += raster.level_at(across, down) / 255.0;
        }
    }
    return sum * raster.columns() * raster.rows() * raster.aspect() /
           (raster.samples_across() * raster.samples_down());
}

std::string drawn(const Raster& raster) {
    Canvas canvas(raster.columns(), raster.rows());
    raster.show(canvas, 0, 0);
    return canvas.text();
}

}  // namespace

TEST_CASE("a disc covers its area") {
    for (const Renderer& renderer : renderers()) {
        for (const double aspect : {1.0, 2.0, 2.6}) {
            for (const double radius : {2.0, 3.7, 9.0}) {
                Raster raster(renderer, 40, 20, aspect);
                raster.disc({19.83, 10.0 * aspect + 0.31}, radius, 0.0, solid);
                // Coverage is linear across a sample, not exact: for a disc of two pixels the error
                // is 5 %. Where borders are sharp, pixels are all or nothing.
                CHECK(painted(raster) == doctest::Approx(3.14159265 * radius * radius)
                                             .epsilon(renderer.is_sharp ? 0.08 : 0.05));
            }
        }
    }
}

TEST_CASE("a centred disc is symmetric") {
    for (const Renderer& renderer : renderers()) {
        Raster raster(renderer, 21, 11, 2.0);
        raster.disc({10.5, 11.0}, 6.3, 0.4, {{}, 0, ' '});
        const int across = raster.samples_across();
        const int down = raster.samples_down();
        for (int y = 0; y < down; ++y) {
            for (int x = 0; x < across; ++x) {
                REQUIRE(raster.level_at(x, y) == raster.level_at(across - 1 - x, y));
                REQUIRE(raster.level_at(x, y) == raster.level_at(x, down - 1 - y));
            }
        }
    }
}

TEST_CASE("a disc is as wide as it is high, whatever the aspect of a cell") {
    for (const double aspect : {1.0, 1.6, 2.0, 2.5}) {
        Raster raster(ascii_renderer(), 60, 40, aspect);
        raster.disc({30.0, 20.0 * aspect}, 12.0, 0.0, solid);
        double width = 0.0;
        double height = 0.0;
        const int middle_down = raster.samples_down() / 2;
        const int middle_across = raster.samples_across() / 2;
        for (int x = 0; x < raster.samples_across(); ++x) {
            width += raster.level_at(x, middle_down) / 255.0 / 2.0;
        }
        for (int y = 0; y < raster.samples_down(); ++y) {
            height += raster.level_at(middle_across, y) / 255.0 * aspect / 3.0;
        }
        CHECK(width == doctest::Approx(24.0).epsilon(0.01));
        CHECK(height == doctest::Approx(24.0).epsilon(0.01));
    }
}

TEST_CASE("a capsule covers its area, in any direction") {
    for (const Renderer& renderer : renderers()) {
        for (int i = 0; i < 12; ++i) {
            const double angle = i * 3.14159265 / 12.0;
            const double x = 10.0 * std::cos(angle);
            const double y = 10.0 * std::sin(angle);
            Raster raster(renderer, 40, 20, 2.0);
            raster.capsule({20.3 - x, 19.8 - y}, {20.3 + x, 19.8 + y}, 3.0, solid);
            const double area = 20.0 * 6.0 + 3.14159265 * 9.0;
            CHECK(painted(raster) ==
                  doctest::Approx(area).epsilon(renderer.is_sharp ? 0.05 : 0.02));
        }
    }
}

TEST_CASE("a capsule whose ends coincide is a disc") {
    for (const Renderer& renderer : renderers()) {
        Raster capsule(renderer, 20, 10, 2.0);
        Raster disc(renderer, 20, 10, 2.0);
        capsule.capsule({9.2, 10.1}, {9.2, 10.1}, 4.0, solid);
        disc.disc({9.2, 10.1}, 4.0, 0.0, solid);
        CHECK(drawn(capsule) == drawn(disc));
    }
}

TEST_CASE("a line of radius 0 has no gaps at any angle") {
    for (const Renderer& renderer : renderers()) {
        for (int i = 0; i < 90; ++i) {
            const double angle = i * 3.14159265 / 90.0;
            const double x = 14.0 * std::cos(angle);
            const double y = 14.0 * std::sin(angle);
            Raster raster(renderer, 40, 20, 2.0);
            raster.line({20.1 - x, 20.2 - y}, {20.1 + x, 20.2 + y}, {});
            Canvas canvas(40, 20);
            raster.show(canvas, 0, 0);
            // Along the line, a sample is lit in or next to each cell that it crosses well inside.
            for (int step = 0; step <= 28; ++step) {
                const double along = step / 14.0 - 1.0;
                const int column = static_cast<int>(20.1 + along * x);
                const int row = static_cast<int>((20.2 + along * y) / 2.0);
                bool is_lit = false;
                for (const int side : {-1, 0, 1}) {
                    for (const int above : {-1, 0, 1}) {
                        is_lit = is_lit || (canvas.holds(column + side, row + above) &&
                                            canvas.at(column + side, row + above).glyph != U' ');
                    }
                }
                CAPTURE(i);
                CAPTURE(canvas.text());
                REQUIRE(is_lit);
            }
        }
    }
}

TEST_CASE("axis-parallel hairlines are one pixel thick at any position") {
    constexpr int least_seen = 43;  // the lowest of three shades
    for (const Renderer& renderer : renderers().subspan(1)) {
        for (double place = 3.0; place < 5.0; place += 0.1) {
            Raster upright(renderer, 10, 5, 2.0);
            upright.capsule({place, -1.0}, {place, 11.0}, 0.0, solid);
            Raster level(renderer, 10, 5, 2.0);
            level.capsule({-1.0, place}, {11.0, place}, 0.0, solid);
            int lit_across = 0;
            int lit_down = 0;
            for (int i = 0; i < upright.samples_across(); ++i)
                lit_across += upright.level_at(i, 5) >= least_seen;
            for (int i = 0; i < level.samples_down(); ++i)
                lit_down += level.level_at(5, i) >= least_seen;
            CAPTURE(place);
            CHECK(lit_across == 1);
            CHECK(lit_down == 1);
        }
    }
}

TEST_CASE("axis-parallel bars of one thickness cover as many pixels at any position") {
    // Down a column or along a row of samples: how many are lit; -1: some are so only partly.
    const auto thickness = [](const Raster& raster, bool is_level) {
        int lit = 0;
        const int most = is_level ? raster.samples_down() : raster.samples_across();
        for (int i = 0; i < most; ++i) {
            const int level = is_level ? raster.level_at(raster.samples_across() / 2, i)
                                       : raster.level_at(i, raster.samples_down() / 2);
            if (level > 0 && level < 255) return -1;
            lit += level > 0;
        }
        return lit;
    };
    for (const Renderer& renderer : renderers()) {
        if (renderer.has_regions()) continue;
        CAPTURE(renderer.name);
        for (const double radius : {0.3, 0.7, 1.1, 2.3})
            for (const bool is_level : {false, true}) {
                CAPTURE(radius);
                CAPTURE(is_level);
                std::optional<int> first;
                for (int step = 0; step < 13; ++step) {
                    Raster raster(renderer, 20, 10, 2.0);
                    const double at = 8.0 + 0.17 * step;
                    if (is_level)
                        raster.capsule({2.0, at}, {18.0, at}, radius, solid);
                    else
                        raster.capsule({at, 2.0}, {at, 18.0}, radius, solid);
                    const int now = thickness(raster, is_level);
                    if (!first) first = now;
                    CHECK(now == *first);
                    CHECK(now > 0);
                }
            }
    }
}

TEST_CASE("bars that share an end meet in a corner without a rest beyond it") {
    for (const double shift : {0.0, 0.2, 0.4, 0.6, 0.8}) {
        Raster raster(half_block_renderer(), 20, 10, 2.0);
        raster.capsule({4.0 + shift, 4.0 + shift}, {16.0, 4.0 + shift}, 0.3, solid);
        raster.capsule({4.0 + shift, 4.0 + shift}, {4.0 + shift, 16.0}, 0.3, solid);
        int beyond = 0;
        for (int down = 0; down < raster.samples_down(); ++down)
            for (int across = 0; across < raster.samples_across(); ++across)
                beyond += raster.level_at(across, down) > 0 && (across < 4 || down < 4);
        CHECK(beyond == 0);
        CHECK(raster.level_at(4, 4) == 255);
    }
}

TEST_CASE("a level line nearly as thick as a pixel is seen wherever it lies") {
    for (const Renderer& renderer : renderers().subspan(1)) {
        const double radius = 0.48 * 2.0 / renderer.down;
        for (double place = 3.0; place < 5.0; place += 0.05) {
            Raster level(renderer, 10, 5, 2.0);
            level.capsule({-1.0, place}, {11.0, place}, radius, solid);
            int lit_down = 0;
            for (int i = 0; i < level.samples_down(); ++i)
                lit_down += level.level_at(5, i) > 200;
            CAPTURE(renderer.name);
            CAPTURE(place);
            CHECK(lit_down == 1);
        }
    }
}

TEST_CASE("dots show the position of a small disc within its cell") {
    Raster raster(ascii_renderer(), 4, 1, 2.0);
    raster.disc({0.25, 0.3}, 0.01, 0.0, solid);
    raster.disc({1.75, 0.3}, 0.01, 0.0, solid);
    raster.disc({2.25, 1.0}, 0.01, 0.0, solid);
    raster.disc({3.25, 1.9}, 0.0, 0.0, solid);
    CHECK(drawn(raster) == "''..\n");

    Raster dots(braille_renderer(), 2, 1, 2.0);
    dots.disc({0.25, 0.2}, 0.01, 0.0, solid);
    dots.disc({1.75, 1.9}, 0.01, 0.0, solid);
    CHECK(drawn(dots) == "⠁⢀\n");
}

TEST_CASE("many dots in a cell make it denser") {
    Raster raster(ascii_renderer(), 2, 1, 2.0);
    for (int i = 0; i < 2000; ++i) {
        raster.disc({1.0 + (i % 40) / 40.0, (i % 37) / 18.5}, 0.01, 0.0, solid);
    }
    raster.disc({0.25, 1.0}, 0.01, 0.0, solid);
    CHECK(drawn(raster) == ".@\n");
}

TEST_CASE("later shapes cover earlier ones, with their colour") {
    Raster raster(ascii_renderer(), 12, 6, 2.0);
    raster.disc({6.0, 6.0}, 5.0, 0.0, {{1, plain}, 255, '#'});
    raster.disc({6.0, 6.0}, 2.9, 0.3, {{2, plain}, 0, ' '});
    Canvas canvas(12, 6);
    raster.show(canvas, 0, 0);
    CHECK(canvas.at(1, 2).foreground == 1);
    CHECK(canvas.at(6, 3).glyph == U' ');
    CHECK(canvas.at(6, 3).foreground == default_color);  // blanks have no colour
    CHECK(canvas.at(3, 3).foreground == 2);
}

TEST_CASE("half blocks show two colours in a cell") {
    Raster raster(half_block_renderer(), 1, 1, 2.0);
    raster.sample(0, 0, 255, {1, plain});
    raster.sample(0, 1, 255, {2, plain});
    Canvas canvas(1, 1);
    raster.show(canvas, 0, 0);
    CHECK(canvas.at(0, 0) == Cell{U'▀', 1, 2, plain});

    Raster lower(half_block_renderer(), 1, 1, 2.0);
    lower.sample(0, 1, 255, {2, plain});
    lower.show(canvas, 0, 0);
    CHECK(canvas.at(0, 0) == Cell{U'▄', 2, default_color, plain});

    Raster same(half_block_renderer(), 1, 1, 2.0);
    same.sample(0, 0, 255, {2, plain});
    same.sample(0, 1, 255, {2, plain});
    same.show(canvas, 0, 0);
    CHECK(canvas.at(0, 0) == Cell{U'█', 2, 2, plain});
}

TEST_CASE("half blocks without colour are lit or dark") {
    Raster raster(half_block_renderer(), 3, 1, 2.0, {.colors = 0});
    raster.sample(0, 0, 255, {});
    raster.sample(1, 1, 255, {});
    raster.sample(2, 0, 200, {});
    raster.sample(2, 1, 200, {});
    CHECK(drawn(raster) == "▀▄█\n");
}

TEST_CASE("borders of half blocks are shaded on terminals with 256 colours") {
    const auto border = [](int colors, Color ground) {
        const Look look{.colors = colors};
        Raster raster(half_block_renderer(), 1, 1, 2.0, look);
        if (ground != default_color) raster.sample(0, 0, 255, {ground, plain});
        raster.sample(0, 0, 128, {196, plain});
        Canvas canvas(1, 1);
        raster.show(canvas, 0, 0);
        return canvas.at(0, 0).foreground;
    };
    CHECK(border(256, default_color) == blended(196, default_color, 0.5, {.colors = 256}));
    CHECK(border(256, 21) == blended(196, 21, 0.5, {.colors = 256}));
    CHECK(border(direct_colors, 21) == direct_color({180, 0, 180}));
    CHECK(border(16, default_color) == 196);
}

TEST_CASE("a dot shows on what is lit already, with few colours too") {
    for (const int colors : {8, 16, 256}) {
        CAPTURE(colors);
        const Look look{colors, true, false};
        Raster raster(half_block_renderer(), 5, 3, 2.0, look);
        const Ink white{7, plain};
        const Ink red{1, plain};
        raster.disc({2.5, 2.5}, 2.0, 0.0, {.ink = white, .is_crisp = true});
        raster.disc({2.5, 2.5}, 0.5, 0.0, {.ink = red, .is_crisp = true});
        Canvas canvas(5, 3);
        raster.show(canvas, 0, 0);
        const Cell& cell = canvas.at(2, 1);
        CHECK(cell.foreground != cell.background);
        CHECK((colors > 16 || cell.foreground == 1 || cell.background == 1));
    }
}

TEST_CASE("a ball of one or two pixels is a full square wherever it lies, not a cross") {
    for (const double radius : {0.5, 0.65, 0.72, 0.9, 1.2}) {
        const int side = 2.0 * radius < 1.414 ? 1 : 2;
        for (const double offset : {0.0, 0.2, 0.5, 0.85}) {
            CAPTURE(radius);
            CAPTURE(offset);
            Raster raster(half_block_renderer(), 20, 10, 2.0);
            raster.ball({10.0 + offset, 9.0 - 0.7 * offset}, radius, {});
            int full = 0;
            int lit = 0;
            for (int down = 0; down < raster.samples_down(); ++down)
                for (int across = 0; across < raster.samples_across(); ++across) {
                    full += raster.level_at(across, down) == 255;
                    lit += raster.level_at(across, down) > 0;
                }
            CHECK(full == side * side);
            CHECK(lit == full);
        }
    }
}

TEST_CASE("a ball of four sextants by three is whole, not a cross") {
    for (const double shift : {0.0, 0.2, 0.4, 0.6, 0.8}) {
        CAPTURE(shift);
        Raster raster(sextant_renderer(), 12, 6, 2.0, {direct_colors, true, false});
        const Color white = direct_color({255, 255, 255});
        raster.ball({5.0 + shift, 6.0 + shift}, 1.05, {.tones = {white, white, white, white}});
        int lit = 0;
        for (int down = 0; down < raster.samples_down(); ++down)
            for (int across = 0; across < raster.samples_across(); ++across)
                lit += raster.level_at(across, down) > 0;
        CHECK(lit == 12);
    }
}

TEST_CASE("a ball of three or four pixels has no faint rim in half blocks") {
    for (const double radius : {1.3, 1.45, 1.6, 1.8, 1.95, 2.2}) {
        const int side = std::max(3, static_cast<int>(2.0 * radius + 0.2));
        for (const double offset : {0.0, 0.2, 0.5, 0.85}) {
            CAPTURE(radius);
            CAPTURE(offset);
            Raster raster(half_block_renderer(), 20, 10, 2.0);
            raster.ball({10.0 + offset, 9.0 - 0.7 * offset}, radius, {});
            int lit = 0;
            int faint = 0;
            for (int down = 0; down < raster.samples_down(); ++down)
                for (int across = 0; across < raster.samples_across(); ++across) {
                    const int level = raster.level_at(across, down);
                    lit += level > 0;
                    faint += level > 0 && level < 100;
                }
            CHECK(lit == side * side);
            CHECK(faint == 0);
        }
    }
}

TEST_CASE("a ball of four pixels is as wide as it is high, with one digit on it and with two") {
    for (const int digits : {0, 1, 2}) {
        CAPTURE(digits);
        Raster raster(half_block_renderer(), 20, 10, 2.0);
        raster.ball({10.3, 9.4}, 1.98, {.number_width = digits});
        double across_middle = 0.0;
        for (int across = 0; across < raster.samples_across(); ++across) {
            int most = 0;
            for (int down = 0; down < raster.samples_down(); ++down)
                most = std::max<int>(most, raster.level_at(across, down));
            across_middle += most / 255.0;
        }
        CHECK(across_middle > 3.6);
        CHECK(across_middle < 4.4);
    }
}

TEST_CASE("shapes outside, huge or not finite paint nothing wrong") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::nan("");
    for (const Renderer& renderer : renderers()) {
        Raster raster(renderer, 20, 10, 2.0);
        for (const double bad : {nan, infinity, -infinity}) {
            raster.disc({bad, 3.0}, 2.0, 0.0, solid);
            raster.disc({3.0, 3.0}, bad, 0.0, solid);
            raster.capsule({bad, 3.0}, {3.0, 3.0}, 2.0, solid);
            raster.capsule({1.0, 3.0}, {3.0, 3.0}, bad, solid);
            raster.line({1.0, bad}, {3.0, 3.0}, {});
        }
        raster.disc({3.0, 3.0}, -1.0, 0.0, solid);
        raster.disc({-30.0, 3.0}, 2.0, 0.0, solid);
        raster.disc({1e300, -1e300}, 2.0, 0.0, solid);
        raster.disc({20.0, 20.0}, 0.0, 0.0, solid);
        raster.disc({-1e-9, 3.0}, 0.0, 0.0, solid);
        raster.capsule({-30.0, 3.0}, {-20.0, 3.0}, 2.0, solid);
        raster.sample(-1, 0, 255, {});
        raster.sample(0, raster.samples_down(), 255, {});
        CHECK(painted(raster) == 0.0);

        // Larger than the window: only its inside is visible.
        raster.disc({10.0, 10.0}, 1e9, 0.3, {{}, 255, '#'});
        CHECK(painted(raster) == doctest::Approx(400.0));
        raster.capsule({-1e12, 10.0}, {1e12, 10.0}, 0.0, solid);
        raster.capsule({-1e12, -1e12}, {1e12, 1e12}, 1e11, solid);
        CHECK(painted(raster) == doctest::Approx(400.0));
    }
}

TEST_CASE("a raster without cells accepts everything and shows nothing") {
    for (const Renderer& renderer : renderers()) {
        Raster raster(renderer, 0, -3, 2.0);
        raster.disc({0.0, 0.0}, 5.0, 0.0, solid);
        raster.line({-1.0, -1.0}, {1.0, 1.0}, {});
        CHECK(drawn(raster).empty());
    }
}

TEST_CASE("a disc, a ring and lines, as they look in ASCII") {
    Raster raster(ascii_renderer(), 44, 8, 2.0);
    raster.disc({8.0, 8.0}, 7.0, 0.0, {{}, 255, '@'});
    raster.disc({24.0, 8.0}, 7.0, 0.26, {{}, 0, ' '});
    raster.line({33.0, 1.0}, {43.0, 15.0}, {});
    raster.line({33.0, 15.0}, {43.0, 1.0}, {});
    CHECK("\n" + drawn(raster) == R"(
    ..;@@;..        ../~~\..     \        /
  ;@@@@@@@@@@;    ;*"      "*;    \      /
 ]@@@@@@@@@@@@[  ]'          '[    \    /
 @@@@@@@@@@@@@@  [            ]      \/
 @@@@@@@@@@@@@@  [            ]      /\
 ]@@@@@@@@@@@@[  ].          .[    /    \
  ^@@@@@@@@@@^    ^\.      ./^    /      \
    '"*@@*"'        '"*~~*"'     /        \
)");
}
