#include <doctest/doctest.h>

#include "physics/event/motion/event_memory.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"
#include "physics/tick/totals.h"

// Ways in which balls came to overlap under `event`, found by fuzzed scenes under `--check`.

using namespace carom;

namespace {

World world_of(double rate, double restitution) {
    World world = scenes::empty();
    world.edit_definition().rate = rate;
    world.edit_definition().kinds[0].restitution = restitution;
    world.edit_definition().materials[0].restitution = restitution;
    world.edit_definition().model.inelastic = restitution < 1.0;
    return world;
}

}  // namespace

// The sum of both accelerations counted as what presses them together, and with it a slow approach
// as none, although they fall side by side.
TEST_CASE("event: balls that fly together under drag meet, however slowly") {
    World world = world_of(120.0, 0.5);
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
    world.edit_definition().model.drag = 5.0;
    add_ball(world, {.position = {0.0, 0.0}, .velocity = {0.01, -1.0}});
    add_ball(world, {.position = {2.001, 0.0}, .velocity = {0.0, -1.0}});
    Solver solver({.kind = SolverKind::event});
    for (int tick = 0; tick < 240; ++tick)
        solver.tick(world);
    CHECK(world.ledger().ball_ball_collisions > 0);
    CHECK(deepest_overlap(world) < 1e-5);
}

// Half of a radius at once, into whatever was there.
TEST_CASE("event: a pair that is separated is not pushed into a third ball") {
    World world = world_of(120.0, 0.5);
    world.edit_definition().model.gravity = Vec2{0.0, -1.0};
    add_ball(world, {.position = {0.0, 0.0}, .velocity = {1.0, 0.0}});
    add_ball(world, {.position = {1.2, 0.0}, .velocity = {-1.0, 0.0}});
    add_ball(world, {.position = {3.2005, 0.0}, .velocity = {}});
    Solver solver({.kind = SolverKind::event});
    solver.tick(world);
    const Balls& balls = world.balls();
    CHECK(distance(balls.position[1], balls.position[2]) > 2.0 - 1e-3);
    // The first one gives way.
    CHECK(balls.position[0].x < -0.1);
}

// The first tick with a hand forgot which balls the hybrid step had left inside one another.
TEST_CASE("event: balls that contact has left overlapping stay in the cluster when a hand comes") {
    World world = world_of(120.0, 0.5);
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
    add_ball(world, {.position = {0.0, 0.0}, .velocity = {}});
    add_ball(world, {.position = {1.99, 0.0}, .velocity = {}});
    add_ball(world, {.position = {50.0, 0.0}, .velocity = {}});
    edit_event_memory(world).clustered = {BallId{0}, BallId{1}, BallId{2}};
    const CapsuleId edge = add_capsule(world, {{100.0, 0.0}, {100.0, 9.0}, 0.0}, 0);
    world.edit_held_capsules() = {{edge, {99.99, 0.0}, {99.99, 9.0}}};
    Solver({.kind = SolverKind::event}).tick(world);
    CHECK(event_memory(world).clustered == std::vector{BallId{0}, BallId{1}});
}
