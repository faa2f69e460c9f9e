#include <algorithm>
#include <vector>

#include <doctest/doctest.h>

#include "geometry/closest.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"
#include "physics/tick/emitters_and_sinks.h"

// The start and the end of every tick.

using namespace carom;

namespace {

World at_ten_ticks_a_second() {
    World world = scenes::empty();
    world.edit_definition().rate = 10.0;
    return world;
}

std::vector<SolverKind> all_solvers() {
    using enum SolverKind;
    return {discrete, substep, swept, contact, event};
}

}  // namespace

TEST_CASE("emitters: one ball in each tick in which its time comes, and no more than the count") {
    World world = at_ten_ticks_a_second();
    world.edit_emitters().push_back({.velocity = {30.0, 0.0}, .every = 0.15, .count = 3});
    Solver solver({.kind = SolverKind::swept});
    // Balls are due at 0, 0.15 and 0.3 s, in the ticks that end after that.
    for (const std::size_t expected : {1u, 2u, 2u, 3u, 3u, 3u}) {
        solver.tick(world);
        CHECK(world.balls().size() == expected);
    }
    CHECK(world.emitters()[0].emitted == 3);
}

TEST_CASE("emitters: a ball waits until its place is free") {
    World world = at_ten_ticks_a_second();
    const BallId in_the_way = add_ball(world, {.position = {0.5, 0.0}});
    world.edit_emitters().push_back({.every = 1.0, .count = 1});
    Solver solver({.kind = SolverKind::swept});
    solver.tick(world);
    CHECK(world.balls().size() == 1);
    remove_ball(world, in_the_way);
    solver.tick(world);
    CHECK(world.balls().size() == 1);
    CHECK(world.emitters()[0].emitted == 1);
}

// The end of a tick stops the ball. A solver that continues from what it left itself must notice.
TEST_CASE("stop speed: a ball that has stopped stays where it is, under every solver") {
    for (const SolverKind kind : all_solvers()) {
        CAPTURE(static_cast<int>(kind));
        World world = at_ten_ticks_a_second();
        world.edit_definition().model.stop_speed = 0.1;
        add_ball(world, {.velocity = {0.05, 0.0}});
        add_ball(world, {.position = {9.0, 0.0}, .velocity = {0.5, 0.0}});
        Solver solver({.kind = kind});
        solver.tick(world);
        CHECK(world.balls().velocity[0] == Vec2{});
        CHECK(world.balls().velocity[1] == Vec2{0.5, 0.0});
        const Vec2 place = world.balls().position[0];
        solver.tick(world);
        solver.tick(world);
        CHECK(world.balls().velocity[0] == Vec2{});
        CHECK(world.balls().position[0] == place);
    }
}

TEST_CASE("sinks: a ball in one is counted and removed, and nothing holds it any more") {
    World world = at_ten_ticks_a_second();
    world.edit_definition().zones.push_back({{{5.0, 0.0}, {5.0, 0.0}, 1.0}, Zone::Effect::sink, 0});
    world.edit_ledger().counters.assign(1, 0);
    const BallId held = add_ball(world, {.position = {4.5, 0.0}});
    const BallId free = add_ball(world, {.position = {20.0, 0.0}});
    world.edit_held_balls() = {{held, {5.0, 0.0}}, {free, {20.0, 0.0}}};
    Solver(SolverSettings{.kind = SolverKind::swept}).tick(world);
    CHECK(world.balls().id == std::vector<BallId>{free});
    CHECK(world.ledger().counters[0] == 1);
    REQUIRE(world.ledger().removed.size() == 1);
    CHECK(world.ledger().removed[0].id == held);
    REQUIRE(world.held_balls().size() == 1);
    CHECK(world.held_balls()[0].id == free);
}

// Six pockets in two rows, and balls everywhere: the same are drained as by comparing each with
// all.
TEST_CASE("sinks: balls between rows of sinks stay, and those in any of them go") {
    World world = at_ten_ticks_a_second();
    std::vector<Capsule> pockets;
    for (const double x : {-10.0, 0.0, 10.0})
        for (const double y : {-5.0, 5.0})
            pockets.push_back({{x, y}, {x, y}, 1.0});
    for (const Capsule& pocket : pockets)
        world.edit_definition().zones.push_back({pocket, Zone::Effect::sink, 0});
    world.edit_ledger().counters.assign(1, 0);
    world.edit_definition().model.ball_ball = false;
    std::vector<BallId> staying;
    for (double x = -11.5; x < 12.0; x += 0.5)
        for (double y = -6.5; y < 7.0; y += 0.5) {
            const Vec2 place{x, y};
            const BallId ball = add_ball(world, {.position = place, .radius = 0.1});
            if (std::ranges::none_of(
                    pockets, [&](const Capsule& pocket) { return is_inside(pocket, place); }))
                staying.push_back(ball);
        }
    const std::size_t count = world.balls().size();
    SinkDrain sinks;
    sinks.drain(world);
    CHECK(world.balls().id == staying);
    CHECK(staying.size() < count);
    CHECK(world.ledger().counters[0] == count - staying.size());

    // A pocket that comes later, in the middle.
    world.edit_definition().zones.push_back({{{0.0, 0.0}, {0.0, 0.0}, 1.0}, Zone::Effect::sink, 0});
    const std::size_t before = world.balls().size();
    sinks.drain(world);
    CHECK(world.balls().size() < before);
    for (const Vec2 place : world.balls().position)
        CHECK(!is_inside(Capsule{{0.0, 0.0}, {0.0, 0.0}, 1.0}, place));
}
