#include "geometry/polygon.h"

#include <doctest/doctest.h>

#include <array>

#include "geometry/vec2.h"

using namespace carom;

TEST_CASE("polygon: a point inside counts, whichever way the corners go round") {
    const std::array<Vec2, 4> square{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}};
    const std::array<Vec2, 4> backwards{{{0, 2}, {2, 2}, {2, 0}, {0, 0}}};
    for (const auto& corners : {square, backwards}) {
        CHECK(is_inside_polygon<Vec2>(corners, {1, 1}));
        CHECK(is_inside_polygon<Vec2>(corners, {1.999, 0.001}));
        CHECK_FALSE(is_inside_polygon<Vec2>(corners, {2.001, 1}));
        CHECK_FALSE(is_inside_polygon<Vec2>(corners, {1, -0.001}));
        CHECK_FALSE(is_inside_polygon<Vec2>(corners, {-1, 1}));
    }
}

TEST_CASE("polygon: a notch is outside") {
    const std::array<Vec2, 5> arrow{{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}};
    CHECK(is_inside_polygon<Vec2>(arrow, {0.5, 2}));
    CHECK(is_inside_polygon<Vec2>(arrow, {3.5, 2}));
    CHECK_FALSE(is_inside_polygon<Vec2>(arrow, {2, 2}));
}

TEST_CASE("polygon: where the outline crosses itself, a part that is inside twice is outside") {
    const std::array<Vec2, 5> star{{{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}}};
    CHECK(is_inside_polygon<Vec2>(star, {0, 2}));
    CHECK_FALSE(is_inside_polygon<Vec2>(star, {0, 0}));
}

TEST_CASE("polygon: fewer than three corners hold nothing") {
    CHECK_FALSE(is_inside_polygon<Vec2>({}, {0, 0}));
    const std::array<Vec2, 2> line{{{-1, -1}, {1, 1}}};
    CHECK_FALSE(is_inside_polygon<Vec2>(line, {0, 0}));
}
