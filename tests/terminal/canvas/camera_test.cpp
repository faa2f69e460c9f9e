#include "terminal/canvas/camera.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace carom;

namespace {

constexpr CellArea window{2, 1, 80, 20};

}  // namespace

TEST_CASE("the whole view is visible, and fills the window in one direction") {
    for (const Box view : {Box{{-3, -2}, {50, 4}}, Box{{0, 0}, {1, 100}}, Box{{5, 5}, {6, 6}}}) {
        for (const double aspect : {1.0, 2.0, 2.5}) {
            const Camera camera = fit_camera(view, window, aspect);
            const Box seen = visible_box(camera);
            CHECK(contains(seen, view.low));
            CHECK(contains(seen, view.high));
            const double across = size(view).x * camera.columns_per_length;
            const double down = size(view).y * camera.columns_per_length / aspect;
            // Half a column of margin on each side in the tighter direction.
            CHECK((std::abs(across - 79.0) < 1e-9 ||
                   std::abs(down * aspect - 20.0 * aspect + 1.0) < 1e-9));
        }
    }
}

TEST_CASE("without a margin a view ends with the cells of the window") {
    const Camera camera = fit_camera({{0, 0}, {30, 40}}, window, 2.0, 0.0);
    CHECK(to_cells(camera, {0, 40}).row == doctest::Approx(window.row));
    CHECK(to_cells(camera, {0, 0}).row == doctest::Approx(window.row + window.rows));
}

TEST_CASE("a part is seen alone, in the middle of the window") {
    const Box part{{10, 20}, {45, 38}};
    for (const CellArea area : {CellArea{0, 0, 100, 37}, CellArea{3, 1, 200, 20},
                                CellArea{0, 0, 80, 21}, CellArea{0, 0, 1, 1}}) {
        CAPTURE(area.columns);
        const Camera camera = fit_camera_to_part(part, area, 2.0);
        const double cell = 1.0 / camera.columns_per_length;
        const Box seen = visible_box(camera);
        if (area.columns > 1) {
            CHECK(contains(grow(part, 2.5 * cell), seen.low));
            CHECK(contains(grow(part, 2.5 * cell), seen.high));
            CHECK(contains(grow(seen, 1e-9), part.low));
            CHECK(contains(grow(seen, 1e-9), part.high));
        }
        const int left = camera.area.column - area.column;
        const int right = area.columns - camera.area.columns - left;
        CHECK(left >= 0);
        CHECK(std::abs(left - right) <= 1);
    }
}

TEST_CASE("mapping a world point to cells and back gives the point") {
    const Camera camera = fit_camera({{-7, 3}, {90, 40}}, window, 1.9);
    for (const Vec2 point : {Vec2{0, 0}, Vec2{-7, 3}, Vec2{1e3, -1e3}, Vec2{41.5, 21.5}}) {
        const Vec2 back = to_world(camera, to_cells(camera, point));
        CHECK(back.x == doctest::Approx(point.x).epsilon(1e-12));
        CHECK(back.y == doctest::Approx(point.y).epsilon(1e-12));
    }
    CHECK(to_cells(camera, camera.center) == CellPoint{42.0, 11.0});
}

TEST_CASE("up in the world is up on the screen") {
    const Camera camera = fit_camera({{0, 0}, {10, 10}}, window, 2.0);
    CHECK(to_cells(camera, {5, 6}).row < to_cells(camera, {5, 5}).row);
    CHECK(to_cells(camera, {6, 5}).column > to_cells(camera, {5, 5}).column);
}

TEST_CASE("a length spans aspect times as many columns as rows") {
    for (const double aspect : {1.0, 1.8, 2.0, 2.7}) {
        const Camera camera = fit_camera({{0, 0}, {10, 10}}, window, aspect);
        const CellPoint origin = to_cells(camera, {0, 0});
        const double across = to_cells(camera, {1, 0}).column - origin.column;
        const double up = origin.row - to_cells(camera, {0, 1}).row;
        CHECK(across == doctest::Approx(up * aspect));
    }
}

TEST_CASE("zooming keeps the point under the mouse") {
    const Camera camera = fit_camera({{0, 0}, {100, 50}}, window, 2.0);
    const CellPoint mouse{17.3, 6.8};
    const Vec2 before = to_world(camera, mouse);
    for (const double factor : {1.25, 0.8, 1000.0}) {
        const Camera closer = zoomed(camera, mouse, factor);
        CHECK(closer.columns_per_length == doctest::Approx(camera.columns_per_length * factor));
        const Vec2 after = to_world(closer, mouse);
        CHECK(after.x == doctest::Approx(before.x));
        CHECK(after.y == doctest::Approx(before.y));
    }
}

TEST_CASE("zooming has limits, and ignores invalid factors") {
    Camera camera = fit_camera({{0, 0}, {100, 50}}, window, 2.0);
    for (const double factor : {0.0, -2.0, std::nan(""), HUGE_VAL}) {
        CHECK(zoomed(camera, {40, 10}, factor) == camera);
    }
    for (int i = 0; i < 1000; ++i)
        camera = zoomed(camera, {40, 10}, 10.0);
    CHECK(camera.columns_per_length == 1e12);
    CHECK(std::isfinite(camera.center.x));
    for (int i = 0; i < 1000; ++i)
        camera = zoomed(camera, {40, 10}, 0.1);
    CHECK(camera.columns_per_length == 1e-12);
    CHECK(std::isfinite(camera.center.x));
}

TEST_CASE("panning by cells moves the picture by cells") {
    const Camera camera = fit_camera({{0, 0}, {100, 50}}, window, 2.0);
    const Camera moved = panned(camera, 3.0, -2.0);
    const Vec2 point{10, 20};
    CHECK(to_cells(moved, point).column == doctest::Approx(to_cells(camera, point).column - 3.0));
    CHECK(to_cells(moved, point).row == doctest::Approx(to_cells(camera, point).row + 2.0));
}

TEST_CASE("everything visible stays visible after a resize") {
    const Camera camera = zoomed(fit_camera({{0, 0}, {100, 50}}, window, 2.0), {20, 5}, 3.0);
    const Box before = visible_box(camera);
    for (const CellArea area : {CellArea{0, 0, 120, 40}, CellArea{0, 0, 30, 30}}) {
        const Camera after = resized(camera, area, 2.0);
        CHECK(after.center == camera.center);
        const Box seen = visible_box(after);
        const double slack = 1e-9 * size(before).x;
        CHECK(contains(grow(seen, slack), before.low));
        CHECK(contains(grow(seen, slack), before.high));
    }
}

TEST_CASE("degenerate views, areas and aspects give a usable camera") {
    for (const Box view : {Box{{5, 5}, {5, 5}}, Box{{0, 1}, {9, 1}}, Box{{0, 1}, {0, 8}}}) {
        for (const CellArea area : {CellArea{0, 0, 0, 0}, CellArea{0, 0, 1, 1}, window}) {
            for (const double aspect : {0.0, -1.0, std::nan(""), HUGE_VAL, 2.0}) {
                const Camera camera = fit_camera(view, area, aspect);
                CHECK(camera.columns_per_length > 0.0);
                CHECK(std::isfinite(camera.columns_per_length));
                CHECK(camera.aspect > 0.0);
                CHECK(std::isfinite(camera.aspect));
            }
        }
    }
}
