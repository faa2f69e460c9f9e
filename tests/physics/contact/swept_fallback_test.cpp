#include "physics/contact/swept_fallback.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "physics/contact/contact_memory.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"
#include "physics/tick/totals.h"
#include "physics/world/fingerprint.h"

using namespace carom;

namespace {

World fast_gas(std::size_t count, double times) {
    World world = scenes::gas(count, 3);
    for (Vec2& velocity : world.edit_balls().velocity)
        velocity *= times;
    return world;
}

void hold_a_ball(World& world) {
    world.edit_held_balls() = {{world.balls().id[5], world.balls().position[5] + Vec2{0.05, 0.0}}};
}

}  // namespace

TEST_CASE("contact: it uses continuous flight only if nothing can press") {
    struct Row {
        std::string what;
        std::function<void(World&)> change;
        bool is_flight_only;
    };
    const std::vector<Row> rows{
        {"a gas", [](World&) {}, true},
        {"on a torus",
         [](World& w) {
             w.edit_definition().model.wrap = Box{{0, 0}, {200, 200}};
         },
         true},
        {"that turns", [](World& w) { w.edit_definition().model.spin = 0.5; }, true},
        {"through one-way edges", [](World& w) { w.edit_definition().model.one_way = true; }, true},
        {"under gravity",
         [](World& w) {
             w.edit_definition().model.gravity = Vec2{0.0, -1.0};
         },
         false},
        {"with drag", [](World& w) { w.edit_definition().model.drag = 0.1; }, false},
        {"with a limit", [](World& w) { w.edit_definition().model.speed_limit = 20.0; }, false},
        {"that loses energy", [](World& w) { w.edit_definition().model.inelastic = true; }, false},
        {"with a ball in a hand", hold_a_ball, false},
        {"with an edge in a hand",
         [](World& w) {
             w.edit_held_capsules().push_back({w.capsules().id[0], {0, 0}, {1, 0}});
         },
         false},
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        World world = scenes::gas(100, 3);
        row.change(world);
        CHECK(is_flight_only(world) == row.is_flight_only);
    }
}

TEST_CASE("contact: flights are cut into substeps only if balls move far in a tick") {
    CHECK(flight_substeps(scenes::empty(), 4) == 1);
    CHECK(flight_substeps(scenes::gas(1000, 3), 4) == 1);
    CHECK(flight_substeps(fast_gas(1000, 3.0), 4) == 2);
    CHECK(flight_substeps(fast_gas(1000, 100.0), 4) == 4);
    CHECK(flight_substeps(fast_gas(1000, 100.0), 1) == 1);
    CHECK(flight_substeps(fast_gas(1000, 1e9), 1000) == 1000);
    World points = fast_gas(10, 1.0);
    points.edit_balls().radius.assign(10, 0.0);
    CHECK(flight_substeps(points, 4) == 4);
}

// Cut into substeps, with fat AABBs that balls could leave when accelerated, balls lost time or
// overlapped, and energy was lost: 9 % in these two seconds.
TEST_CASE("contact: a fast gas keeps its energy, and nothing overlaps") {
    World world = fast_gas(200, 100.0);
    const double energy = totals(world).kinetic_energy;
    Solver solver({.kind = SolverKind::contact});
    for (int i = 0; i < 120; ++i) {
        solver.tick(world);
        CHECK(deepest_overlap(world) < 1e-9);
    }
    CHECK(totals(world).kinetic_energy == doctest::Approx(energy).epsilon(1e-11));
}

// Beyond the budget of work, time stands still for a ball, which keeps its speed.
TEST_CASE("elastic flights: a jammed ball keeps its energy, however often it bounces") {
    for (const SolverKind kind : {SolverKind::contact, SolverKind::swept}) {
        CAPTURE(static_cast<int>(kind));
        // Back and forth in a channel, 167,000 times a tick.
        World world = scenes::empty();
        world.edit_definition().rate = 60.0;
        add_capsule(world, {{-50.0, -1.5}, {50.0, -1.5}, 1.0}, 0);
        add_capsule(world, {{-50.0, 1.5001}, {50.0, 1.5001}, 1.0}, 0);
        add_ball(world, {.position = {0.0, 0.0}, .velocity = {0.3, 1000.0}, .radius = 0.5});
        const double energy = totals(world).kinetic_energy;
        const auto bounces = world.ledger().ball_edge_collisions;
        Solver solver({.kind = kind});
        for (int i = 0; i < 5; ++i)
            solver.tick(world);
        CHECK(world.ledger().ball_edge_collisions > bounces + 5 * 4000);
        CHECK(totals(world).kinetic_energy == doctest::Approx(energy).epsilon(1e-11));
        CHECK(std::abs(world.balls().position[0].y) < 1.0001e-4);
    }
}

TEST_CASE("contact: in pure flight it has the bits of swept, whatever its substeps") {
    World pressed = scenes::gas(300, 3);
    World swept = pressed;
    Solver contact({.kind = SolverKind::contact, .contact_substeps = 16});
    Solver flights({.kind = SolverKind::swept, .substeps = 1});
    for (int i = 0; i < 60; ++i) {
        contact.tick(pressed);
        flights.tick(swept);
    }
    CHECK(pressed.ledger().ball_ball_collisions > 100);
    CHECK(contact_memory(pressed).reference.ball.empty());
    CHECK(fingerprint(pressed) == fingerprint(swept));
}

// The choice of method in a tick depends on the world alone: a fresh solver makes the same one.
TEST_CASE("contact: between flights and kinematic bodies it continues as a fresh solver would") {
    World seen = scenes::gas(200, 3);
    World unseen = seen;
    Solver solver({.kind = SolverKind::contact});
    for (int i = 0; i < 60; ++i) {
        const bool is_held = i % 7 >= 4;
        for (World* world : {&seen, &unseen}) {
            world->edit_held_balls().clear();
            if (is_held) hold_a_ball(*world);
        }
        solver.tick(seen);
        Solver stranger({.kind = SolverKind::contact});
        stranger.tick(unseen);
        CHECK(contact_memory(seen).reference.ball.empty() == !is_held);
        REQUIRE(fingerprint(seen) == fingerprint(unseen));
    }
}
