#include "lab/measure/difference.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace carom;

namespace {

Positions balls(std::vector<std::uint32_t> ids, std::vector<Vec2> places) {
    Positions positions;
    for (const std::uint32_t id : ids)
        positions.id.push_back(BallId{id});
    positions.position = std::move(places);
    return positions;
}

}  // namespace

TEST_CASE("the difference covers the balls that both worlds have") {
    const Positions a = balls({0, 1, 3}, {{0, 0}, {1, 1}, {5, 5}});
    const Positions b = balls({1, 2, 3}, {{1, 1}, {9, 9}, {8, 9}});
    const Difference off = difference(a, b, std::nullopt);
    CHECK(off.rms == std::sqrt(25.0 / 2));
    CHECK(off.max == 5.0);
    CHECK(off.farthest == BallId{3});
    CHECK(off.unpaired == 2);
}

TEST_CASE("no balls, no difference") {
    const Difference off = difference({}, {}, std::nullopt);
    CHECK(off.rms == 0.0);
    CHECK(off.max == 0.0);
    CHECK(off.farthest == std::nullopt);
    CHECK(off.unpaired == 0);
}

TEST_CASE("on a torus the nearest images count") {
    const Difference off = difference(balls({0}, {{0.1, 5}}), balls({0}, {{9.9, 5}}), Vec2{10, 10});
    CHECK(off.max == doctest::Approx(0.2));
}

TEST_CASE("a ball whose position is not finite is infinitely far off") {
    constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
    const Difference off = difference(balls({0, 1}, {{no_number, 0}, {1, 1}}),
                                      balls({0, 1}, {{0, 0}, {1, 1}}), std::nullopt);
    CHECK(std::isinf(off.rms));
    CHECK(std::isinf(off.max));
    CHECK(off.farthest == BallId{0});
}

TEST_CASE("the mean radius includes balls that are yet to be emitted") {
    World world;
    CHECK(mean_radius(world) == 1.0);
    world.edit_definition().kinds = {Kind{.radius = 2.0}, Kind{.radius = 5.0}};
    add_ball(world, {.kind = 0, .position = {0, 0}});
    CHECK(mean_radius(world) == 2.0);
    world.edit_emitters().push_back({.kind = 1, .count = 3, .emitted = 1});
    CHECK(mean_radius(world) == 4.0);
}
