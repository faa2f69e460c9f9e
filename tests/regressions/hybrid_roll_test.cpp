#include <doctest/doctest.h>

#include "physics/event/motion/event_memory.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"

// Balls lost their roll in the hybrid step of the solver `event`. The loader refuses cloth with
// gravity, but a player can turn gravity on over a table with cloth: the engine then read a column
// that was empty.

using namespace carom;

TEST_CASE("event: a hybrid step on cloth under gravity keeps the roll of every ball") {
    World world = scenes::empty();
    world.edit_definition().rate = 240.0;
    world.edit_definition().model.spin = 0.4;
    world.edit_definition().model.cloth = Cloth{};
    world.edit_definition().model.inelastic = true;
    world.edit_definition().kinds[0].restitution = 0.9;
    add_ball(world, {.position = {0.0, 0.0}, .velocity = {}, .roll = Vec2{0.25, 0.5}});
    add_ball(world, {.position = {1.9, 0.0}, .velocity = {}, .roll = Vec2{0.125, 0.75}});
    add_ball(world, {.position = {50.0, 0.0}, .velocity = {3.0, 0.0}, .roll = Vec2{-2.0, 1.0}});
    world.edit_definition().model.gravity = Vec2{0.0, -1.0};
    const World start = world;
    edit_event_memory(world).clustered = {BallId{0}};
    Solver solver({.kind = SolverKind::event});
    REQUIRE(solver.tick(world) == TickOutcome::done);
    REQUIRE(world.balls().roll.size() == 3);
    // `contact`, which steps the cluster, knows no cloth.
    CHECK(world.balls().roll[0] == start.balls().roll[0]);
    CHECK(world.balls().roll[1] == start.balls().roll[1]);
    // The ball outside the cluster slips, so its roll changes as it would without a cluster.
    World alone = start;
    remove_ball(alone, BallId{0});
    remove_ball(alone, BallId{1});
    Solver({.kind = SolverKind::event}).tick(alone);
    CHECK_FALSE(world.balls().roll[2] == start.balls().roll[2]);
    CHECK(world.balls().roll[2] == alone.balls().roll[0]);
    CHECK(world.balls().velocity[2] == alone.balls().velocity[0]);
}
