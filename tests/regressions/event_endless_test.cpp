#include <cmath>

#include <doctest/doctest.h>

#include "physics/event/motion/ball_impact.h"
#include "physics/event/motion/edge_impact.h"
#include "physics/event/motion/event_memory.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"

// Ticks of the solver `event` that did not end. A ball on the border of two cells was transferred
// back and forth; a ball that slid along an edge, overlapping it by less than rounding, met the
// edge's end again and again; a ball dragged into a wedge bounced between its two sides; elastic
// balls that drag or friction brought to rest on one another collided ever faster.

using namespace carom;

namespace {

// Whether each of `ticks` ticks ends within a few thousand events.
bool ends(World& world, int ticks) {
    Solver solver({.kind = SolverKind::event});
    for (int tick = 0; tick < ticks; ++tick) {
        int asked = 0;  // every 4096 events
        if (solver.tick(world, [&] { return ++asked < 5; }) != TickOutcome::done) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("event: a ball that moves along a cell border is not transferred back and forth") {
    // The borders may lie anywhere.
    for (int cells = 1; cells <= 12; ++cells)
        for (int cell = 0; cell < cells; ++cell) {
            CAPTURE(cells);
            CAPTURE(cell);
            World world = scenes::empty();
            world.edit_definition().model.wrap = Box{{0.0, 0.0}, {12.0, 12.0}};
            world.edit_definition().model.drag = 0.5;
            world.edit_definition().model.gravity = Vec2{0.0, -10.0};
            for (int i = 0; i < 12; ++i)
                add_ball(world, {.position = {0.5 + i, 1.0}, .radius = 0.4});
            add_ball(world, {.position = {12.0 * cell / cells, 11.0}, .radius = 0.4});
            CHECK(ends(world, 10));
        }
}

TEST_CASE("event: a ball that starts turning on a cell border is not transferred back and forth") {
    for (int cells = 1; cells <= 12; ++cells)
        for (int cell = 0; cell < cells; ++cell) {
            CAPTURE(cells);
            CAPTURE(cell);
            World world = scenes::empty();
            world.edit_definition().model.wrap = Box{{0.0, 0.0}, {12.0, 12.0}};
            world.edit_definition().model.gravity = Vec2{0.0, -10.0};
            for (int i = 0; i < 12; ++i)
                add_ball(world, {.position = {0.5 + i, 1.0}, .radius = 0.4});
            const Vec2 place{12.0 * cell / cells, 11.0};
            const Vec2 peg = place - Vec2{0.6, 0.8};
            add_capsule(world, {peg, peg, 0.6}, 0);
            add_ball(world, {.position = place, .radius = 0.4});
            REQUIRE(ends(world, 1));
            CHECK(event_memory(world).trajectories.lines.back().motion == Motion::turning);
        }
}

TEST_CASE(
    "event: a ball that slides past the end of an edge, overlapping it by rounding, continues") {
    for (int depth = -20; depth <= 60; ++depth) {
        CAPTURE(depth);
        World world = scenes::empty();
        add_capsule(world, {{0.0, 0.0}, {5.0, 0.0}, 0.2}, 0);
        add_ball(
            world,
            {.position = {2.0, 0.7 - depth * 0.5e-15}, .velocity = {100.0, 0.0}, .radius = 0.5});
        REQUIRE(ends(world, 10));
        CHECK(world.balls().position[0].x > 10.0);
        CHECK(world.balls().position[0].y == doctest::Approx(0.7).epsilon(1e-6));
    }
}

TEST_CASE("event: a ball dragged into a wedge stays in it") {
    for (const double target : {-0.4, -0.1, 0.0, 0.1, 0.4}) {
        CAPTURE(target);
        World world = scenes::empty();
        add_capsule(world, {{0.0, 0.0}, {100.0, 5.0}, 0.0}, 0);
        add_capsule(world, {{0.0, 0.0}, {100.0, -5.0}, 0.0}, 0);
        const BallId ball = add_ball(world, {.position = {20.0, 0.0}, .radius = 0.5});
        world.edit_held_balls() = {{ball, {2.0, target}}};
        REQUIRE(ends(world, 60));
        // Both edges are as far away as possible.
        const double deepest = 0.5 * std::sqrt(100.0 * 100.0 + 5.0 * 5.0) / 5.0;
        CHECK(world.balls().position[0].x == doctest::Approx(deepest).epsilon(1e-6));
        CHECK(std::abs(world.balls().position[0].y) < 1e-6);
    }
}

// A ball jammed among three others was left with the smallest denormal as its speed. Rounding kept
// impacts from reducing it further.
TEST_CASE("event: an approach at the smallest representable speed is no impact") {
    const Edge<double> wall(Capsule{{0.0, -1.0}, {0.0, 1.0}, 0.0}, {});
    const Edge<double> peg(Capsule{{0.0, 0.0}, {0.0, 0.0}, 0.0}, {});
    for (const double speed : {5e-324, 1e-320, 1e-310, 1e-300}) {
        CAPTURE(speed);
        Trajectory<double> trajectory;
        trajectory.position = {0.5, 0.0};
        trajectory.velocity = {-speed, 0.0};
        ToiSearch<double> search;
        CHECK(!edge_time_of_impact(trajectory, wall, 0.5, Field<double>{}, 1.0, search));
        CHECK(!edge_time_of_impact(trajectory, peg, 0.5, Field<double>{}, 1.0, search));
        Trajectory<double> other;
        CHECK(!ball_time_of_impact(trajectory, other, {}, 0.5, 0.25, Field<double>{}, 1.0, search));
    }
}

// A ball was pushed into a wedge until it had hardly any speed left. Then it met one side of the
// wedge again and again.
TEST_CASE("event: a slip on cloth that is shorter than the clock resolves ends at once") {
    World world = scenes::empty();
    world.edit_definition().model.spin = 0.4;
    world.edit_definition().model.cloth = Cloth{};
    world.edit_definition().model.inelastic = true;
    world.edit_definition().kinds[0].restitution =
        world.edit_definition().materials[0].restitution = 0.23479314322297762;
    world.edit_definition().rate = 91.367009479875293;
    world.edit_tick() = 39;
    add_capsule(world, {{0.0, 12.0}, {0.0, 0.0}, 0.1}, 0);
    add_capsule(
        world,
        {{1.0579249775954223, 1.6944907455177463}, {0.88895036006671146, 1.9289293202502973}, 0.05},
        0);
    const Vec2 corner{0.6, 1.3891908503178798};
    add_ball(world, {.position = corner, .radius = 0.5, .roll = Vec2{}});
    add_ball(world, {.position = {1.3309120063014124, 0.7067192534440716},
                     .velocity = {-0.0056060425050721372, -0.0055245823540975812},
                     .radius = 0.5,
                     .roll = Vec2{-0.60241657068506416, 0.23396926626568393}});
    CHECK(ends(world, 20));
    CHECK(length(world.balls().position[0] - corner) < 1e-3);
}

TEST_CASE("event: elastic balls that drag or friction stops collide less than once a tick") {
    const auto collisions_of_last_second = [](auto lose) {
        World world = scenes::empty();
        world.edit_definition().model.gravity = Vec2{0.0, -10.0};
        world.edit_definition().rate = 120.0;
        lose(world.edit_definition());
        scenes::add_walls(world, {{0.0, 0.0}, {11.7, 15.0}});
        for (int i = 0; i < 12; ++i)
            add_ball(world, {.position = {1.5 + 2.6 * (i % 4) + 0.3 * (i / 4), 3.0 + 2.5 * (i / 4)},
                             .radius = 1.0,
                             .restitution = 1.0});
        Solver solver({.kind = SolverKind::event});
        for (int tick = 0; tick < 9 * 120; ++tick)
            solver.tick(world);
        const std::uint64_t before = world.ledger().ball_ball_collisions;
        for (int tick = 0; tick < 120; ++tick)
            solver.tick(world);
        return world.ledger().ball_ball_collisions - before;
    };
    // One for each ball in a tick.
    const std::uint64_t most = 12 * 120;
    CHECK(collisions_of_last_second([](Definition& d) { d.model.drag = 2.0; }) < most);
    CHECK(collisions_of_last_second([](Definition& d) {
              d.model.spin = 0.5;
              d.kinds[0].friction = 0.4;
              d.materials[0].friction = 0.4;
          }) < most);
}
