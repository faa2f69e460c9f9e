#include "physics/event/motion/trajectories.h"

#include <doctest/doctest.h>

#include "physics/support/event_parts.h"
#include "physics/support/scenes.h"

using namespace carom;

TEST_CASE("trajectories: a start voids predictions and is logged") {
    World world = scenes::empty();
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
    add_ball(world, {.position = {1.0, 2.0}, .velocity = {3.0, 0.0}, .radius = 0.5});
    EventParts parts(world);
    const std::uint32_t version = parts.balls[0].version;
    parts.trajectories.begin_log(true);
    parts.scene.now += 1.0;
    CHECK(Vec2(parts.trajectories.position_now(0)) == Vec2{4.0, -3.0});
    parts.trajectories.start(0, parts.scene.now, {4.0, -3.0}, {0.0, 0.0});
    CHECK(parts.balls[0].version == version + 1);
    REQUIRE(parts.trajectories.started().size() == 1);
    CHECK(parts.trajectories.started()[0] == 0);
    CHECK(Vec2(parts.balls.curve(0).acceleration) == Vec2{0.0, -10.0});
    parts.trajectories.begin_log(false);
    parts.trajectories.start(0, parts.scene.now, {4.0, -3.0}, {0.0, 0.0});
    CHECK(parts.trajectories.started().empty());
}

TEST_CASE("trajectories: on a torus they start in the frame, and images change") {
    World world = scenes::empty();
    world.edit_definition().model.wrap = Box{{0.0, 0.0}, {10.0, 10.0}};
    add_ball(world, {.position = {5.0, 5.0}, .radius = 0.5});
    EventParts parts(world);
    const std::uint64_t changes = parts.trajectories.image_changes();
    parts.trajectories.start(0, parts.scene.now, {6.0, 5.0}, {});
    CHECK(parts.trajectories.image_changes() == changes);
    parts.trajectories.start(0, parts.scene.now, {12.0, 5.0}, {});
    CHECK(parts.trajectories.image_changes() == changes + 1);
    CHECK(Vec2(parts.balls[0].line.position) == Vec2{2.0, 5.0});
}

TEST_CASE("trajectories: a start keeps the present spin") {
    World world = scenes::empty();
    world.edit_definition().model.spin = 0.5;
    add_ball(world, {.radius = 0.5, .spin = 4.0});
    EventParts parts(world);
    parts.trajectories.spin(0).rate = -1.0;
    const double later = parts.scene.now + 3.0;
    CHECK(parts.trajectories.spin_at(0, later) == 1.0);
    parts.trajectories.start(0, later, {}, {});
    CHECK(parts.trajectories.spin(0).spin == 1.0);
    CHECK(parts.trajectories.spin(0).rate == 0.0);
}
