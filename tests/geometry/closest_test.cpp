#include "geometry/closest.h"

#include <doctest/doctest.h>

using namespace carom;

TEST_CASE("the closest point of a segment may be an end or an interior point") {
    const Vec2 a{1.0, 1.0};
    const Vec2 b{5.0, 1.0};
    CHECK(closest_point(a, b, {3.0, 7.0}) == Vec2{3.0, 1.0});
    CHECK(closest_point(a, b, {-3.0, 7.0}) == a);
    CHECK(closest_point(a, b, {9.0, -2.0}) == b);
    CHECK(closest_point(a, a, {9.0, -2.0}) == a);
    CHECK(closest_parameter(a, a, {9.0, -2.0}) == 0.0);
}

TEST_CASE("separation of overlapping bodies is minus the depth") {
    CHECK(separation(Disc{{0, 0}, 1}, Disc{{3, 0}, 1}) == 1.0);
    CHECK(separation(Disc{{0, 0}, 1}, Disc{{0, 0}, 2}) == -3.0);
    CHECK(separation(Disc{{2, 3}, 1}, Capsule{{0, 0}, {4, 0}, 0.5}) == 1.5);
    CHECK(is_inside({{0, 0}, {4, 0}, 0.5}, {4.5, 0}));
    CHECK_FALSE(is_inside({{0, 0}, {4, 0}, 0.5}, {4.51, 0}));
}

TEST_CASE("direction gives a unit vector for tiny and huge vectors") {
    for (const double size : {1e-300, 1e-200, 1.0, 1e200, 1e300}) {
        const Vec2 d = direction({3 * size, -4 * size}, {});
        CHECK(d.x == doctest::Approx(0.6).epsilon(1e-15));
        CHECK(d.y == doctest::Approx(-0.8).epsilon(1e-15));
    }
    CHECK(direction({0, 0}, {0, 1}) == Vec2{0, 1});
}
