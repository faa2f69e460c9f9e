#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/closest.h"
#include "geometry/elementary.h"
#include "physics/solver.h"
#include "physics/solver_table.h"
#include "physics/support/cancelled.h"
#include "physics/support/scenes.h"
#include "physics/tick/totals.h"
#include "physics/world/fingerprint.h"

// Edges that move by themselves, against closed forms, and what they do where they jam.

using namespace carom;

namespace {

constexpr SolverKind all_solvers[] = {SolverKind::discrete, SolverKind::substep, SolverKind::swept,
                                      SolverKind::contact, SolverKind::event};
constexpr SolverKind good_solvers[] = {SolverKind::swept, SolverKind::contact, SolverKind::event};

CapsuleId add_moved(World& world, Mover mover, const Capsule& home) {
    const CapsuleId id = add_capsule(world, mover_shape(mover, {{}, home}, mover.clock), 0);
    mover.edges = {{id, home}};
    world.edit_movers().push_back(mover);
    return id;
}

Mover sliding(Vec2 by, double period) {
    return {.period = period, .is_round = false, .path = {{}, by}};
}

// The invariant (v + u) L of a ball between a wall at 0 and a piston that comes from 10.1 at 0.1:
// see driven_edge_test.cpp. The worst share by which it changes, until L is a tenth.
double worst_error(SolverKind kind, double rate) {
    constexpr double radius = 0.05;
    World world = scenes::empty();
    world.edit_definition().rate = rate;
    add_capsule(world, {{0.0, -5.0}, {0.0, 5.0}, 0.0}, 0);
    Mover mover = sliding({-10.0, 0.0}, 200.0);
    mover.is_steady = true;
    const CapsuleId piston = add_moved(world, mover, {{10.1, -5.0}, {10.1, 5.0}, 0.0});
    add_ball(world, {.position = {3.0, 0.0}, .velocity = {1.7, 0.0}, .radius = radius});
    Solver solver({.kind = kind});
    double constant = 0.0;
    double worst = 0.0;
    for (double width = 10.0; width > 1.0;) {
        solver.tick(world);
        REQUIRE(world.movers()[0].share == 1.0);
        for (const Contact& contact : solver.contacts()) {
            if (contact.b != number(piston)) continue;
            width = 10.1 - 0.1 * contact.time - 2.0 * radius;
            const double product = contact.approach * width;
            if (constant == 0.0) constant = product;
            worst = std::max(worst, std::fabs(product / constant - 1.0));
        }
        REQUIRE(world.time() < 100.0);
    }
    return worst;
}

// A bar about the origin, once in four seconds, which meets a ball at rest at (distance, 0).
World bar_and_ball(double distance, double rate) {
    World world = scenes::empty();
    world.edit_definition().rate = rate;
    const double begin = -1.0;
    add_moved(world, {.period = 4.0, .angle = 2.0 * pi},
              {{}, Vec2{std::cos(begin), std::sin(begin)} * 3.0, 0.0});
    add_ball(world, {.position = {distance, 0.0}, .radius = 0.1});
    return world;
}

// A lift below a ceiling that leaves 0.7 of a ball of diameter 1.
World jam() {
    World world = scenes::empty();
    world.edit_definition().rate = 240.0;
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
    world.edit_definition().kinds[0] = {.radius = 0.5, .mass = 1.0, .restitution = 0.5};
    world.edit_definition().materials[0].restitution = 0.5;
    world.edit_definition().model.inelastic = true;
    add_capsule(world, {{-5.0, 3.0}, {5.0, 3.0}, 0.0}, 0);
    add_capsule(world, {{-1.0, -1.0}, {-1.0, 3.0}, 0.0}, 0);
    add_capsule(world, {{1.0, -1.0}, {1.0, 3.0}, 0.0}, 0);
    add_moved(world, sliding({0.0, 2.3}, 4.0), {{-1.0, 0.0}, {1.0, 0.0}, 0.0});
    add_ball(world, {.position = {0.1, 0.5}});
    return world;
}

}  // namespace

TEST_CASE("movers: the place of an edge is a function of the clock") {
    const MovedEdge edge{{}, {{1.0, 0.0}, {3.0, 0.0}, 0.1}};
    const Mover turn{.period = 4.0, .pivot = {1.0, 0.0}, .angle = -2.0 * pi};
    CHECK(mover_shape(turn, edge, 0.0) == edge.home);
    CHECK(length(mover_shape(turn, edge, 1.0).end - Vec2{1.0, -2.0}) < 1e-15);
    const Mover swing{.period = 4.0, .is_round = false, .pivot = {1.0, 0.0}, .angle = pi / 2.0};
    CHECK(length(mover_shape(swing, edge, 2.0).end - Vec2{1.0, 2.0}) < 1e-15);
    CHECK(length(mover_shape(swing, edge, 1.0).end - Vec2{1.0, 0.0} -
                 Vec2{std::sqrt(2.0), std::sqrt(2.0)}) < 1e-15);
    Mover slide = sliding({0.0, 2.0}, 8.0);
    CHECK(length(mover_shape(slide, edge, 4.0).start - Vec2{1.0, 2.0}) < 1e-15);
    CHECK(mover_shape(slide, edge, 1.0).start.y == doctest::Approx(1.0 - std::sqrt(0.5)));
    slide.is_steady = true;
    CHECK(mover_shape(slide, edge, 1.0).start.y == 0.5);
    CHECK(mover_shape(slide, edge, 7.0).start.y == 0.5);
    // A square, a side of which takes a quarter of the round.
    const Mover loop{.period = 4.0, .path = {{}, {1, 0}, {1, 1}, {0, 1}, {}}};
    for (const auto& [clock, place] : {std::pair{0.5, Vec2{1.5, 0.0}},
                                       {1.0, {2.0, 0.0}},
                                       {1.25, {2.0, 0.25}},
                                       {2.5, {1.5, 1.0}},
                                       {3.75, {1.0, 0.25}}})
        CHECK(length(mover_shape(loop, edge, clock).start - place) < 1e-15);
}

TEST_CASE("movers: a clock wraps round, and stops evenly in time") {
    Mover mover{.period = 2.0, .angle = 1.0, .clock = 1.9};
    CHECK(clock_after(mover, 0.2).clock == doctest::Approx(0.1));
    CHECK(clock_after(mover, 0.2).runs);
    mover.stops = 4;
    std::vector<double> stops;
    mover.clock = 0.0;
    for (int tick = 0; tick < 1000 && stops.size() < 5; ++tick) {
        const MoverClock next = clock_after(mover, 0.013);
        mover.clock = next.clock;
        if (!next.runs) stops.push_back(next.clock);
    }
    CHECK(stops == std::vector<double>{0.5, 1.0, 1.5, 0.0, 0.5});
}

TEST_CASE("movers: a piston at constant speed keeps (v + u) L of a ball") {
    for (const double rate : {60.0, 240.0}) {
        CAPTURE(rate);
        CHECK(worst_error(SolverKind::event, rate) < 1e-9);
        CHECK(worst_error(SolverKind::swept, rate) < 1e-9);
        CHECK(worst_error(SolverKind::contact, rate) < 1e-3);
    }
}

TEST_CASE("movers: a turning bar throws a ball with twice its speed at the contact") {
    for (const SolverKind kind : good_solvers) {
        CAPTURE(name(kind));
        for (const double distance : {0.5, 1.5, 2.5}) {
            CAPTURE(distance);
            World world = bar_and_ball(distance, 1000.0);
            Solver solver({.kind = kind});
            while (world.balls().velocity[0] == Vec2{} && world.time() < 1.0)
                solver.tick(world);
            // The bar touches it beside the spine, `foot` from the pivot.
            const double foot = std::sqrt(distance * distance - 0.01);
            const Vec2 along{foot / distance, -0.1 / distance};
            const Vec2 expected = perpendicular(along) * (2.0 * 0.5 * pi * foot);
            // Within a tick the ends go along chords.
            CHECK(length(world.balls().velocity[0] - expected) < 1e-3 * length(expected));
            CHECK(world.movers()[0].share == 1.0);
        }
    }
}

TEST_CASE("movers: a mover waits for a ball that it would crush, and goes on without it") {
    for (const SolverKind kind : all_solvers) {
        CAPTURE(name(kind));
        World world = jam();
        Solver solver({.kind = kind});
        const CapsuleId lift = world.movers()[0].edges[0].capsule;
        // Solvers that bounce what overlaps press the ball as they press it on fixed edges.
        const bool is_rough = row_of(kind).overlaps_at_impacts;
        const double least = is_rough ? 0.1 : kind == SolverKind::contact ? 0.43 : 0.49;
        double highest = 0.0;
        for (int tick = 0; tick < 240 * 10; ++tick) {
            solver.tick(world);
            REQUIRE(world.balls().size() == 1);
            const Vec2 place = world.balls().position[0];
            const double y = world.capsules().shape[*index_of(world, lift)].start.y;
            highest = std::max(highest, y);
            REQUIRE(place.y > y + least);
            REQUIRE(place.y < 3.0 - least);
            REQUIRE(length(world.balls().velocity[0]) < 20.0);
        }
        // It has got as far as the ball lets it, and its clock stands.
        CHECK(highest > 1.95);
        CHECK(world.movers()[0].runs);
        if (!is_rough) CHECK(highest < 3.0 - 2.0 * least);
        if (!is_rough) CHECK(world.movers()[0].clock < 2.0);
        remove_ball(world, BallId{0});
        const double clock = world.movers()[0].clock;
        for (int tick = 0; tick < 240; ++tick)
            solver.tick(world);
        CHECK(world.movers()[0].clock == doctest::Approx(clock + 1.0).epsilon(0.02));
    }
}

TEST_CASE("movers: only the mover that jams waits") {
    World world = jam();
    add_moved(world, {.period = 1.0, .pivot = {20.0, 0.0}, .angle = 2.0 * pi},
              {{20.0, 0.0}, {22.0, 0.0}, 0.0});
    Solver solver({.kind = SolverKind::event});
    for (int tick = 0; tick < 240 * 5; ++tick)
        solver.tick(world);
    CHECK(world.movers()[0].share < 1.0);
    CHECK(world.movers()[1].share == 1.0);
    CHECK(std::min(world.movers()[1].clock, 1.0 - world.movers()[1].clock) < 1e-9);
}

TEST_CASE("movers: one that does not run is a fixed edge, and costs what that costs") {
    for (const SolverKind kind : all_solvers) {
        CAPTURE(name(kind));
        World world = scenes::gas(50, 3);
        World fixed = world;
        Mover mover{.period = 1.0, .angle = 2.0 * pi, .runs = false};
        add_moved(world, mover, {{0.0, 0.0}, {9.0, 9.0}, 0.1});
        add_capsule(fixed, {{0.0, 0.0}, {9.0, 9.0}, 0.1}, 0);
        Solver solver({.kind = kind});
        Solver other({.kind = kind});
        for (int tick = 0; tick < 100; ++tick) {
            solver.tick(world);
            other.tick(fixed);
        }
        CHECK(world.balls().position == fixed.balls().position);
        CHECK(world.held_capsules().empty());
    }
}

TEST_CASE("movers: one that stops waits where it is until it is started again") {
    for (const SolverKind kind : all_solvers) {
        CAPTURE(name(kind));
        World world = scenes::empty();
        world.edit_definition().rate = 100.0;
        const CapsuleId edge =
            add_moved(world, {.period = 1.0, .angle = 2.0 * pi, .stops = 2}, {{}, {1.0, 0.0}, 0.1});
        const auto end = [&] { return world.capsules().shape[*index_of(world, edge)].end; };
        Solver solver({.kind = kind});
        for (int round = 0; round < 3; ++round) {
            CAPTURE(round);
            for (int tick = 0; tick < 70; ++tick)
                solver.tick(world);
            CHECK_FALSE(world.movers()[0].runs);
            CHECK(distance(end(), {round % 2 == 0 ? -1.0 : 1.0, 0.0}) < 1e-9);
            world.edit_movers()[0].runs = true;
        }
    }
}

TEST_CASE("movers: a copy of the world continues with the same bits, also under a new solver") {
    for (const SolverKind kind : all_solvers) {
        CAPTURE(name(kind));
        World world = scenes::gas(60, 9);
        world.edit_definition().model.gravity = Vec2{0.0, -10.0};
        add_moved(world, {.period = 1.5, .pivot = {8.0, 8.0}, .angle = 2.0 * pi},
                  {{4.0, 8.0}, {12.0, 8.0}, 0.1});
        Solver solver({.kind = kind});
        for (int tick = 0; tick < 100; ++tick)
            solver.tick(world);
        World copy = world;
        REQUIRE(fingerprint(copy) == fingerprint(world));
        for (int tick = 0; tick < 100; ++tick) {
            solver.tick(world);
            Solver({.kind = kind}).tick(copy);
        }
        CHECK(fingerprint(copy) == fingerprint(world));
        // The fingerprint has the clock.
        copy.edit_movers()[0].clock += 1e-12;
        CHECK(fingerprint(copy) != fingerprint(world));
    }
}

TEST_CASE("movers: a cancelled tick leaves the world unchanged") {
    for (const SolverKind kind : {SolverKind::substep, SolverKind::swept, SolverKind::event}) {
        CAPTURE(name(kind));
        World start = scenes::gas(1000, 6);
        start.edit_definition().rate = 0.5;
        add_moved(start, {.period = 30.0, .pivot = {20.0, 20.0}, .angle = 2.0 * pi},
                  {{0.0, 20.0}, {40.0, 20.0}, 0.1});
        World world = start;
        Solver solver({.kind = kind});
        cancel_at_each_poll(world, solver, [&] { REQUIRE(world.movers() == start.movers()); });
    }
}

TEST_CASE("movers: a removed edge leaves its mover, which moves the others") {
    World world = scenes::empty();
    const CapsuleId first = add_moved(world, sliding({0.0, 2.0}, 1.0), {{0, 0}, {1, 0}, 0.1});
    const CapsuleId second = add_capsule(world, {{1, 0}, {2, 0}, 0.1}, 0);
    world.edit_movers()[0].edges.push_back({second, {{1, 0}, {2, 0}, 0.1}});
    CHECK(is_moved_by_mover(world, first));
    remove_capsule(world, first);
    CHECK_FALSE(is_moved_by_mover(world, first));
    Solver solver({.kind = SolverKind::swept});
    while (world.time() < 0.5)
        solver.tick(world);
    CHECK(length(world.capsules().shape[0].start - Vec2{1.0, 2.0}) < 1e-9);
    remove_capsule(world, second);
    solver.tick(world);
    CHECK(world.held_capsules().empty());
}
