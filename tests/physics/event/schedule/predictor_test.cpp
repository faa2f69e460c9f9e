#include "physics/event/schedule/predictor.h"

#include <cmath>

#include <doctest/doctest.h>

#include "physics/support/event_parts.h"
#include "physics/support/scenes.h"

using namespace carom;

TEST_CASE("predictor: the first of a collision, an edge and a cell transfer is next") {
    // Close enough to be in adjacent cells.
    World world = scenes::empty();
    add_ball(world, {.position = {0.0, 0.0}, .velocity = {1.0, 0.0}, .radius = 0.5});
    add_ball(world, {.position = {1.0 + 1.0 / 128, 0.0}, .velocity = {-1.0, 0.0}, .radius = 0.5});
    EventParts parts(world);
    parts.predictor.predict(0);
    const BallEvent<double> collision = parts.balls.plan(0).collision();
    CHECK(collision.kind == EventKind::ball_ball);
    CHECK(collision.other == 1);
    CHECK(collision.other_version == parts.balls[1].version);
    CHECK(collision.time == parts.scene.now + 1.0 / 256);
    // The prediction of the other ball has the same bits.
    parts.predictor.predict(1);
    CHECK(parts.balls.plan(1).collision().time == collision.time);
    CHECK(parts.balls.plan(1).collision().other == 0);
    parts.schedule.rebuild();
    CHECK(parts.schedule.first() == 0);
    // A new trajectory of the partner voids it.
    parts.trajectories.start(1, parts.scene.now, {1.25, 0.0}, {1.0, 0.0});
    CHECK(collision.other_version != parts.balls[1].version);
    parts.predictor.predict(0);
    CHECK(parts.balls.plan(0).collision().kind == EventKind::none);
}

TEST_CASE("predictor: an edge in the way precedes a ball behind it") {
    World world = scenes::empty();
    add_ball(world, {.position = {0.0, 0.0}, .velocity = {1.0, 0.0}, .radius = 0.5});
    add_ball(world, {.position = {1.0 + 1.0 / 128, 0.0}, .radius = 0.5});
    add_capsule(world, {{0.5 + 1.0 / 256, -5.0}, {0.5 + 1.0 / 256, 5.0}, 0.0}, 0);
    EventParts parts(world);
    parts.predictor.predict(0);
    CHECK(parts.balls.plan(0).next_event().kind == EventKind::ball_edge);
    CHECK(parts.balls.plan(0).next_event().time == parts.scene.now + 1.0 / 256);
    CHECK(parts.balls.plan(0).collision().kind == EventKind::ball_ball);
}

TEST_CASE("predictor: resting balls have no impact with each other, but with others") {
    World world = scenes::empty();
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
    world.edit_definition().model.inelastic = true;
    add_capsule(world, {{-9.0, 0.0}, {9.0, 0.0}, 0.0}, 0);
    add_ball(world, {.position = {0.0, 0.5}, .radius = 0.5});
    add_ball(world, {.position = {1.0, 0.5}, .radius = 0.5});
    add_ball(world, {.position = {0.0, 1.5 + 1.0 / 128}, .radius = 0.5});
    EventParts parts(world);
    for (std::uint32_t i = 0; i < 3; ++i)
        parts.rest.settle(i);
    REQUIRE(parts.balls[0].line.motion == Motion::resting);
    parts.predictor.predict(1);
    CHECK(parts.balls.plan(1).next_event().kind != EventKind::ball_edge);
    CHECK(parts.balls.plan(1).next_event().kind != EventKind::ball_ball);
    parts.predictor.predict(2);
    CHECK(parts.balls.plan(2).next_event().kind == EventKind::ball_ball);
    CHECK(parts.balls.plan(2).next_event().time ==
          doctest::Approx(parts.scene.now + std::sqrt(0.2 / 128)).epsilon(1e-12));
}
