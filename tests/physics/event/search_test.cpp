#include <cmath>
#include <cstdint>
#include <vector>

#include <doctest/doctest.h>

#include "physics/event/engine.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"

// How long the solver `event` looks for impacts where no closed form finds them.

using namespace carom;

namespace {

// An edge in a hand that sweeps, with its other end as a pivot, from one side of it to the other in
// one tick, and a ball that all but touches it at the pivot: for half of the tick the two are a
// hair apart, which the bound on what the edge does there takes for nearly an impact.
World sweeping() {
    World world = scenes::empty();
    world.rate = 1.0;
    add_ball(world, {.position = {-0.5 - 1e-11, 0.0}, .radius = 0.5});
    const CapsuleId edge = add_capsule(world, {{0.0, 0.0}, {10.0, 0.0}, 0.0}, 0);
    world.held_capsules = {{edge, {0.0, 0.0}, {-10.0, 1.0}}};
    return world;
}

// Of the next tick of such a world.
std::uint64_t looks_of_tick(World world) {
    EventEngine<double> engine;
    std::vector<Contact> contacts;
    std::vector<std::uint8_t> touched(world.balls.size());
    CHECK(engine.tick(world, contacts, touched, {}) == EventOutcome::done);
    CHECK(contacts.empty());
    return engine.looks();
}

}  // namespace

// It was left off after a million looks, as one that finds nothing: the edge went through the ball.
TEST_CASE("event: what a long search looks for is met") {
    World world = sweeping();
    Solver solver({.kind = SolverKind::event});
    CHECK(solver.tick(world) == TickOutcome::done);
    REQUIRE(!solver.contacts().empty());
    CHECK(solver.contacts().front().time == doctest::Approx(0.5).epsilon(1e-3));
    CHECK(world.balls.velocity[0].y < -1.0);
}

// Nobody was asked before the search had ended.
TEST_CASE("event: a tick that searches long can be given up") {
    World world = sweeping();
    Solver solver({.kind = SolverKind::event});
    int asked = 0;
    CHECK(solver.tick(world, [&] { return ++asked < 10; }) == TickOutcome::given_up);
    CHECK(asked == 10);
    CHECK(world.tick == 0);
    CHECK(solver.tick(world) == TickOutcome::done);
    World straight = sweeping();
    Solver(SolverSettings{.kind = SolverKind::event}).tick(straight);
    CHECK(world.balls.velocity == straight.balls.velocity);
    CHECK(world.balls.position == straight.balls.position);
}

// The ways apart that drag leaves two balls at the same speed are known for good: nothing presses
// the one on the other. Looked at as two on their own, each step was as short as the gap is small.
TEST_CASE("event: balls that drag carries side by side take few looks") {
    for (const double gap : {1e-3, 1e-6, 1e-9})
        for (const double faster : {0.0, 1e-6}) {
            CAPTURE(gap);
            CAPTURE(faster);
            World world = scenes::empty();
            world.rate = 10.0;
            world.model.drag = 0.5;
            add_ball(world, {.velocity = {10.0, 1.0}, .radius = 0.5});
            add_ball(
                world,
                {.position = {0.0, 1.0 + gap}, .velocity = {10.0, 1.0 + faster}, .radius = 0.5});
            CHECK(looks_of_tick(world) < 200);
        }
}

TEST_CASE("event: an edge in a hand that does not move takes no more looks than a fixed one") {
    for (const bool falls : {false, true})
        for (const double gap : {1e-3, 1e-6, 1e-9}) {
            CAPTURE(falls);
            CAPTURE(gap);
            World world = scenes::empty();
            world.rate = 10.0;
            if (falls) world.model.gravity = Vec2{0.0, -10.0};
            // Past the end of the edge, and not towards it.
            add_ball(world, {.position = {-0.5 - gap, 0.0}, .velocity = {0.0, 5.0}, .radius = 0.5});
            const Capsule shape{{0.0, 0.0}, {10.0, 0.0}, 0.0};
            const CapsuleId edge = add_capsule(world, shape, 0);
            const std::uint64_t fixed = looks_of_tick(world);
            world.held_capsules = {{edge, shape.start, shape.end}};
            const std::uint64_t held = looks_of_tick(world);
            CHECK(held <= fixed + 2);
        }
}

// One that would squeeze a ball stops, for the rest of the tick.
TEST_CASE("event: an edge in a hand that has stopped takes no more looks than one that stood") {
    Field<double> field;
    field.gravity = {0.0, -10.0};
    EventPath<double> path;
    path.acceleration = field.gravity;
    path.velocity = {0.0, 5.0};
    for (const double gap : {1e-3, 1e-6, 1e-9}) {
        CAPTURE(gap);
        path.position = {-0.5 - gap, 0.0};
        MovingEdge<double> edge;
        edge.edge = Edge<double>(Capsule{{0.0, 0.0}, {10.0, 0.0}, 0.0}, {});
        edge.stop = -1.0;
        edge.time = -1.0;
        ClosingSearch<double> stood;
        CHECK(!hand_closing(path, edge, 0.5, field, 0.0, 0.1, stood));
        edge.start_velocity = {0.0, -3.0};
        edge.end_velocity = {0.0, 40.0};
        ClosingSearch<double> stopped;
        CHECK(!hand_closing(path, edge, 0.5, field, 0.0, 0.1, stopped));
        CHECK(stopped.looks == stood.looks);
    }
}
