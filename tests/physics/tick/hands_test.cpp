#include "physics/tick/hands.h"

#include <utility>

#include <doctest/doctest.h>

#include "physics/support/scenes.h"

using namespace carom;

TEST_CASE("hands: a tick first tries twice the share of the last one, and a new hand the whole") {
    World world = scenes::empty();
    const BallId ball = add_ball(world, {.position = {0.0, 0.0}, .radius = 0.5});
    world.edit_held_balls().push_back({ball, {5.0, 0.0}});
    HandStep step;
    for (const auto& [expected, used] : {std::pair{1.0, 0.25}, {0.5, 0.125}, {0.25, 0.0}}) {
        REQUIRE(step.begin(world));
        CHECK(step.first_share() == expected);
        step.aim(world, used);
        step.end(world, used);
        CHECK(world.held_balls()[0].target == Vec2{5.0, 0.0});
    }
    // After hands that stood still, the least share is tried again.
    REQUIRE(step.begin(world));
    CHECK(step.first_share() == 1.0 / 64.0);
    step.end(world, 0.25);
    world.edit_held_balls().clear();
    CHECK_FALSE(step.begin(world));
    world.edit_held_balls().push_back({ball, {5.0, 0.0}});
    REQUIRE(step.begin(world));
    CHECK(step.first_share() == 1.0);
}
