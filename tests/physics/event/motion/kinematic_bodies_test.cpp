#include "physics/event/motion/kinematic_bodies.h"

#include <doctest/doctest.h>

#include "physics/support/event_parts.h"
#include "physics/support/scenes.h"

using namespace carom;

TEST_CASE("kinematic bodies: they reach their targets in a tick, or stop for the rest of it") {
    World world = scenes::empty();
    world.edit_definition().rate = 2.0;
    const BallId ball = add_ball(world, {.position = {0.0, 0.0}, .radius = 0.5});
    add_ball(world, {.position = {9.0, 9.0}, .velocity = {1.0, 0.0}, .radius = 0.5});
    const CapsuleId edge = add_capsule(world, {{5.0, 0.0}, {5.0, 1.0}, 0.0}, 0);
    world.edit_held_balls() = {{ball, {1.0, 0.0}}};
    world.edit_held_capsules() = {{edge, {6.0, 0.0}, {7.0, 1.0}}};
    EventParts parts(world);
    CHECK(parts.balls.plan(0).inverse_mass == 0.0);
    CHECK(parts.balls[0].line.motion == Motion::held);
    CHECK(Vec2(parts.balls[0].line.velocity) == Vec2{2.0, 0.0});
    REQUIRE(parts.kinematic.edges().size() == 1);
    const MovingEdge<double> moving = parts.kinematic.edges()[0].edge;
    CHECK(Vec2(moving.at(parts.scene.end).start) == Vec2{6.0, 0.0});
    CHECK(Vec2(moving.at(parts.scene.end).end) == Vec2{7.0, 1.0});
    CHECK(!parts.kinematic.take_stopped());

    parts.scene.now += 0.25;
    parts.kinematic.stop();
    CHECK(parts.kinematic.take_stopped());
    CHECK(!parts.kinematic.take_stopped());
    CHECK(Vec2(parts.kinematic.edges()[0].edge.at(parts.scene.end).start) == Vec2{5.5, 0.0});
    CHECK(Vec2(parts.balls[0].line.position) == Vec2{0.5, 0.0});
    CHECK(Vec2(parts.balls[0].line.velocity) == Vec2{});
    CHECK(Vec2(parts.balls[1].line.velocity) == Vec2{1.0, 0.0});
    // All of them are already at rest.
    parts.kinematic.stop();
    CHECK(!parts.kinematic.take_stopped());
}
