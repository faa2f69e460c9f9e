#include "terminal/panels/curve_panel.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace carom;

TEST_CASE("a curve is drawn with its ranges, in ASCII") {
    CurvePicture picture{.title = "msd", .value = "4", .points = {}};
    for (int i = 0; i <= 40; ++i)
        picture.points.push_back({i / 20.0, i / 20.0 * i / 20.0, {}});
    Canvas canvas(40, 8);
    draw_curve(canvas, {0, 0, 40, 8}, picture, {0, false, false});
    const std::string text = canvas.text();
    CHECK(text.starts_with("msd  4\n4 "));
    CHECK(text.find("\n0 ") != std::string::npos);
    CHECK(text.ends_with("  0                                    2\n"));
}

TEST_CASE("curves without points, small panels and numbers that are not finite do no harm") {
    const Look look{0, false, false};
    CurvePicture picture{.title = "g", .value = "no value", .points = {}};
    Canvas canvas(40, 10);
    draw_curve(canvas, {0, 0, 40, 10}, picture, look);
    CHECK(canvas.text().starts_with("g  no value\n"));
    picture.points = {{0.0, std::nan(""), {}}, {1.0, HUGE_VAL, {}}, {2.0, -1e300, 1e300}};
    draw_curve(canvas, {0, 0, 40, 10}, picture, look);
    picture.points.push_back({3.0, 1.0, HUGE_VAL});
    for (const CellArea area :
         {CellArea{0, 0, 40, 10}, CellArea{0, 0, 16, 4}, CellArea{0, 0, 3, 3}})
        draw_curve(canvas, area, picture, look);
}

TEST_CASE("a bar goes on behind the curve that crosses it") {
    CurvePicture picture{.title = "speeds", .value = "", .points = {}, .has_bars = true};
    for (int i = 0; i <= 40; ++i)
        picture.points.push_back({i / 40.0, i < 20 ? 2.0 : 0.1, 1.0});
    for (const int colors : {direct_colors, 8, 0}) {
        CAPTURE(colors);
        const Look look{colors, true, false};
        Canvas canvas(40, 12);
        draw_curve(canvas, {0, 0, 40, 12}, picture, look);
        const Color bar = ink_of_class(1, look).color;
        int on_bars = 0;
        int beside = 0;
        for (int row = 0; row < canvas.rows(); ++row)
            for (int column = 0; column < canvas.columns(); ++column) {
                const Cell& cell = canvas.at(column, row);
                if (cell.glyph <= U'\u2800' || cell.glyph > U'\u28ff') continue;
                const bool is_on_bar =
                    colors == 0 ? (cell.attributes & reverse) != 0 : cell.background == bar;
                ++(is_on_bar ? on_bars : beside);
            }
        CHECK(on_bars > 5);
        CHECK(beside > 5);
    }
}
