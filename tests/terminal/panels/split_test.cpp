#include "terminal/panels/split.h"

#include <doctest/doctest.h>

#include <initializer_list>
#include <utility>

using namespace carom;

namespace {

constexpr Look no_colors{0, false, false};

}  // namespace

TEST_CASE("halves are equal, within the area, and do not overlap") {
    const Box square{{0.0, 0.0}, {10.0, 10.0}};
    for (const auto& [columns, rows] : {std::pair{80, 21}, {81, 21}, {20, 7}, {300, 97}, {1, 1}}) {
        const CellArea area{0, 0, columns, rows};
        const Split halves = split(area, square, 2.0);
        CHECK(halves.first.columns == halves.second.columns);
        CHECK(halves.first.rows == halves.second.rows);
        const bool is_beside = halves.second.row == halves.first.row;
        CHECK((halves.second.column + halves.second.columns == columns || !is_beside));
        CHECK(halves.second.row + halves.second.rows <= rows);
        CHECK((halves.first.column + halves.first.columns < halves.second.column ||
               halves.first.row + halves.first.rows < halves.second.row || columns == 1));
    }
}

TEST_CASE("halves are side by side, unless the view is much larger in stacked halves") {
    const CellArea area{0, 0, 80, 21};
    CHECK(split(area, {{0.0, 0.0}, {10.0, 10.0}}, 2.0).second.row == 1);
    CHECK(split(area, {{0.0, 0.0}, {100.0, 10.0}}, 2.0).second.row == 11);
}

TEST_CASE("a title has the solver, and more if there is room") {
    const Box view{{0.0, 0.0}, {10.0, 10.0}};
    const auto drawn = [&](int columns) {
        Canvas canvas(columns, 4);
        draw_split(canvas, split({0, 0, columns, 4}, view, 2.0), {"swept", 120, 7},
                   {"event", 120, 9}, no_colors);
        return canvas.text();
    };
    CHECK(drawn(80).starts_with(
        " swept  tick 120     7 collisions      |  event  tick 120     9 collisions\n"));
    CHECK(drawn(41).starts_with(" swept  tick 120    | event  tick 120\n"));
    CHECK(drawn(20).starts_with(" swept   |  event\n"));
}
