#include "terminal/canvas/table_camera.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace carom;

namespace {

const Box table{{0.0, 0.0}, {0.5, 1.0}};
constexpr double radius = 0.0135;

}  // namespace

TEST_CASE("a window in which the ball is large enough shows the whole table") {
    TableCamera camera;
    const CellArea area{0, 0, 80, 60};
    CHECK(camera.look(table, radius, 1.0, area, 2.0) == fit_camera(table, area, 2.0));
}

TEST_CASE("a low window shows the flippers first, and at least 60 % of the table") {
    TableCamera camera;
    const CellArea area{0, 0, 60, 20};
    const Box seen = visible_box(camera.look(table, radius, 1.0, area, 2.0));
    CHECK(seen.low.y == doctest::Approx(0.0));
    CHECK(seen.high.y >= 0.599);
    CHECK(seen.high.y < 0.9);
    CHECK(seen.low.x <= 0.0);
    CHECK(seen.high.x >= 0.5);
}

TEST_CASE("the view glides after the ball, stops at the ends, and never jumps") {
    TableCamera camera;
    const CellArea area{0, 0, 60, 20};
    double before = camera.look(table, radius, 1.0, area, 2.0).center.y;
    double fastest = 0.0;
    for (int frame = 0; frame < 120; ++frame) {
        camera.follow(0.95, 0.0, 1.0 / 60.0);
        const double now = camera.look(table, radius, 1.0, area, 2.0).center.y;
        CHECK(now >= before - 1e-12);
        fastest = std::max(fastest, now - before);
        before = now;
    }
    CHECK(visible_box(camera.look(table, radius, 1.0, area, 2.0)).high.y == doctest::Approx(1.0));
    CHECK(fastest < 0.04);
    // Near the centre a ball moves nothing.
    TableCamera calm;
    const double start = calm.look(table, radius, 1.0, area, 2.0).center.y;
    calm.follow(start + 0.02, 0.0, 1.0);
    CHECK(calm.look(table, radius, 1.0, area, 2.0).center.y == start);
}

TEST_CASE("the camera glides from the part around the ball to the whole table and back") {
    TableCamera camera;
    const CellArea area{0, 0, 60, 20};
    const auto scale = [&] {
        return camera.look(table, radius, 1.0, area, 2.0).columns_per_length;
    };
    const double near = scale();
    camera.approach(false, 0.2);
    const double between = scale();
    CHECK(between < near);
    camera.approach(false, 1.0);
    CHECK(camera.look(table, radius, 1.0, area, 2.0) == fit_camera(table, area, 2.0));
    CHECK(scale() < between);
    camera.approach(true, 1.0);
    CHECK(scale() == near);
}
