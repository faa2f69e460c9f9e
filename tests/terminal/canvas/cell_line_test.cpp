#include "terminal/canvas/cell_line.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

#include "terminal/canvas/glyph.h"
#include "terminal/canvas/raster.h"

using namespace carom;

namespace {

constexpr Brush solid{{}, 255, '\0'};

std::string drawn(const Raster& raster) {
    Canvas canvas(raster.columns(), raster.rows());
    raster.show(canvas, 0, 0);
    return canvas.text();
}

}  // namespace

TEST_CASE("lines in ASCII, as people draw them") {
    Raster raster(ascii_renderer(), 44, 8, 2.0);
    raster.line({2.0, 1.0}, {12.0, 1.0}, {});    // the upper half of a row
    raster.line({2.0, 13.8}, {12.0, 13.8}, {});  // the bottom of one
    raster.line({2.5, 1.0}, {2.5, 14.0}, {});
    raster.line({16.0, 2.0}, {22.0, 14.0}, {});
    raster.line({24.0, 13.0}, {42.0, 3.0}, {});
    CHECK("\n" + drawn(raster) == R"(
  +---------
  |             \                       _.
  |              \                   .-'
  |               \              _--'
  |                \         _.-'
  |                 \     _-'
  +_________         \  -'

)");
}

TEST_CASE("a line is one character thick wherever it lies") {
    for (int i = 0; i < 200; ++i) {
        const double place = 4.0 + 0.031 * i;
        Raster upright(ascii_renderer(), 20, 10, 2.0);
        upright.line({place, 0.0}, {place, 20.0}, {});
        Raster level(ascii_renderer(), 20, 10, 2.0);
        level.line({0.0, place}, {20.0, place}, {});
        const auto ink_of = [](const Raster& raster) {
            const std::string text = drawn(raster);
            return std::ranges::count_if(text, [](char c) { return c != ' ' && c != '\n'; });
        };
        CHECK(ink_of(upright) == 10);
        CHECK(ink_of(level) == 20);
    }
}

TEST_CASE("a line that sinks by a row changes its character once within the row") {
    const auto glyph_at = [](double y) {
        Raster raster(ascii_renderer(), 3, 3, 2.0);
        raster.line({0.0, y}, {3.0, y}, {});
        std::string text = drawn(raster);
        std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
        return text;
    };
    int changes = 0;
    std::string before = glyph_at(2.0);
    for (double y = 2.0; y < 4.0; y += 0.02) {
        const std::string now = glyph_at(y);
        changes += now != before ? 1 : 0;
        before = now;
    }
    CHECK(changes == 1);
}

TEST_CASE("a polyline of short pieces has no gaps, and no letters") {
    Raster raster(ascii_renderer(), 40, 20, 2.0);
    constexpr int pieces = 90;
    const auto at = [](int i) {
        const double angle = 2.0 * 3.14159265 * i / pieces;
        return RasterPoint{20.0 + 15.0 * std::cos(angle), 20.0 + 15.0 * std::sin(angle)};
    };
    for (int i = 0; i < pieces; ++i)
        raster.capsule(at(i), at(i + 1), 0.2, solid);
    Canvas canvas(40, 20);
    raster.show(canvas, 0, 0);
    for (int i = 0; i < pieces; ++i) {
        bool is_near = false;
        for (const int side : {-1, 0, 1})
            for (const int above : {-1, 0, 1})
                is_near = is_near || canvas.at(static_cast<int>(at(i).x) + side,
                                               static_cast<int>(at(i).y / 2.0) + above)
                                             .glyph != U' ';
        CHECK(is_near);
    }
    const std::string text = canvas.text();
    CHECK(text.find_first_not_of(" \n-_.'`|/\\+") == std::string::npos);
}

TEST_CASE("what is drawn later covers a line, and a later line what is there") {
    Raster raster(ascii_renderer(), 9, 1, 2.0);
    raster.line({0.0, 1.0}, {9.0, 1.0}, {});
    raster.stamp({2.5, 1.0}, "(o)", {});
    raster.stamp({7.0, 1.0}, "()", {});
    raster.line({6.5, 0.0}, {6.5, 2.0}, {});
    CHECK(drawn(raster) == "-(o)--|)-\n");
}

TEST_CASE("shapes are drawn without letters") {
    for (const ShapeGlyph& shape : shape_glyphs())
        CHECK_FALSE(std::isalnum(static_cast<unsigned char>(shape.glyph)));
}
