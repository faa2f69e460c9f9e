#include "physics/event/motion/time_of_impact.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include <doctest/doctest.h>

#include "physics/event/engine.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"

// Times of impact without a closed form, and the number of iterations they take.

using namespace carom;

namespace {

// A kinematic edge sweeps by 180 degrees in one tick, with one end as a pivot, and a ball is 1e-11
// from the pivot. For half of the tick the two stay that close, and the acceleration bound forces
// tiny steps.
World sweeping() {
    World world = scenes::empty();
    world.edit_definition().rate = 1.0;
    add_ball(world, {.position = {-0.5 - 1e-11, 0.0}, .radius = 0.5});
    const CapsuleId edge = add_capsule(world, {{0.0, 0.0}, {10.0, 0.0}, 0.0}, 0);
    world.edit_held_capsules() = {{edge, {0.0, 0.0}, {-10.0, 1.0}}};
    return world;
}

// The number of iterations in the next tick of the world.
std::uint64_t iterations_of_tick(World world) {
    EventEngine<double> engine;
    std::vector<Contact> contacts;
    std::vector<std::uint8_t> touched(world.balls().size());
    CHECK(engine.tick(world, contacts, touched, {}) == EventOutcome::done);
    CHECK(contacts.empty());
    return engine.iterations();
}

}  // namespace

// Regression: such a search gave up after a million iterations, and the edge went through the ball.
TEST_CASE("time of impact: a suspended search finds its impact") {
    World world = sweeping();
    Solver solver({.kind = SolverKind::event});
    CHECK(solver.tick(world) == TickOutcome::done);
    REQUIRE(!solver.contacts().empty());
    CHECK(solver.contacts().front().time == doctest::Approx(0.5).epsilon(1e-3));
    CHECK(world.balls().velocity[0].y < -1.0);
}

// Regression: the token was asked only after the search had ended.
TEST_CASE("time of impact: a tick with a long search can be cancelled") {
    World world = sweeping();
    Solver solver({.kind = SolverKind::event});
    int asked = 0;
    CHECK(solver.tick(world, [&] { return ++asked < 10; }) == TickOutcome::cancelled);
    CHECK(asked == 10);
    CHECK(world.tick() == 0);
    CHECK(solver.tick(world) == TickOutcome::done);
    World straight = sweeping();
    Solver(SolverSettings{.kind = SolverKind::event}).tick(straight);
    CHECK(world.balls().velocity == straight.balls().velocity);
    CHECK(world.balls().position == straight.balls().position);
}

// Drag acts equally on two balls of equal speed, so nothing presses them together. With one bound
// for each, each step was as short as the gap is small.
TEST_CASE("time of impact: balls slowed by drag side by side take few iterations") {
    for (const double gap : {1e-3, 1e-6, 1e-9})
        for (const double faster : {0.0, 1e-6}) {
            CAPTURE(gap);
            CAPTURE(faster);
            World world = scenes::empty();
            world.edit_definition().rate = 10.0;
            world.edit_definition().model.drag = 0.5;
            add_ball(world, {.velocity = {10.0, 1.0}, .radius = 0.5});
            add_ball(
                world,
                {.position = {0.0, 1.0 + gap}, .velocity = {10.0, 1.0 + faster}, .radius = 0.5});
            CHECK(iterations_of_tick(world) < 200);
        }
}

TEST_CASE("time of impact: a held edge at rest takes no more iterations than a fixed one") {
    for (const bool falls : {false, true})
        for (const double gap : {1e-3, 1e-6, 1e-9}) {
            CAPTURE(falls);
            CAPTURE(gap);
            World world = scenes::empty();
            world.edit_definition().rate = 10.0;
            if (falls) world.edit_definition().model.gravity = Vec2{0.0, -10.0};
            // Beside the end of the edge, and moving past it.
            add_ball(world, {.position = {-0.5 - gap, 0.0}, .velocity = {0.0, 5.0}, .radius = 0.5});
            const Capsule shape{{0.0, 0.0}, {10.0, 0.0}, 0.0};
            const CapsuleId edge = add_capsule(world, shape, 0);
            const std::uint64_t fixed = iterations_of_tick(world);
            world.edit_held_capsules() = {{edge, shape.start, shape.end}};
            const std::uint64_t held = iterations_of_tick(world);
            CHECK(held <= fixed + 2);
        }
}

// A kinematic edge that would squeeze a ball stops for the rest of the tick.
TEST_CASE("time of impact: a stopped kinematic edge takes no more iterations than one at rest") {
    Field<double> field;
    field.gravity = {0.0, -10.0};
    Trajectory<double> trajectory;
    trajectory.acceleration = field.gravity;
    trajectory.velocity = {0.0, 5.0};
    for (const double gap : {1e-3, 1e-6, 1e-9}) {
        CAPTURE(gap);
        trajectory.position = {-0.5 - gap, 0.0};
        MovingEdge<double> edge;
        edge.edge = Edge<double>(Capsule{{0.0, 0.0}, {10.0, 0.0}, 0.0}, {});
        edge.stop = -1.0;
        edge.time = -1.0;
        ToiSearch<double> stood;
        CHECK(!moving_edge_time_of_impact(trajectory, edge, 0.5, field, 0.0, 0.1, stood));
        edge.start_velocity = {0.0, -3.0};
        edge.end_velocity = {0.0, 40.0};
        ToiSearch<double> stopped;
        CHECK(!moving_edge_time_of_impact(trajectory, edge, 0.5, field, 0.0, 0.1, stopped));
        CHECK(stopped.iterations == stood.iterations);
    }
}
