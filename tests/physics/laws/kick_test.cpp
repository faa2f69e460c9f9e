#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "physics/laws/bounce.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"

using namespace carom;

namespace {

/// One ball of radius 1 that falls at `speed`, at `x`, on an edge from -5,0 to 5,0.
World above_an_edge(const Material& material, double x, double speed) {
    World world = scenes::empty();
    world.edit_definition().rate = 100.0;
    world.edit_definition().materials[0] = material;
    add_capsule(world, {{-5.0, 0.0}, {5.0, 0.0}, 0.0}, 0);
    add_ball(world, {.kind = 0, .position = {x, 1.3}, .velocity = {0.5, -speed}});
    return world;
}

Vec2 velocity_after_hit(World world, SolverKind kind) {
    Solver solver({.kind = kind});
    for (int tick = 0; tick < 400 && world.ledger().ball_edge_collisions == 0; ++tick)
        solver.tick(world);
    REQUIRE(world.ledger().ball_edge_collisions == 1);
    return world.balls().velocity[0];
}

}  // namespace

TEST_CASE("a bumper adds its kick along the normal, in every solver, if the hit is hard enough") {
    const Material bumper{.restitution = 0.5, .kick = 3.0, .kick_from = 0.2};
    for (const SolverKind kind : solvers_available()) {
        CAPTURE(name(kind));
        const Vec2 kicked = velocity_after_hit(above_an_edge(bumper, 0.0, 2.0), kind);
        CHECK(kicked.x == doctest::Approx(0.5).epsilon(1e-12));
        CHECK(kicked.y == doctest::Approx(4.0).epsilon(1e-12));
        const Vec2 soft = velocity_after_hit(above_an_edge(bumper, 0.0, 0.1), kind);
        CHECK(soft.y == doctest::Approx(0.05).epsilon(1e-12));
    }
}

TEST_CASE("a slingshot kicks hardest at its middle, and not at its ends") {
    const Material sling{.restitution = 1.0, .kick = 2.0, .kicks_in_the_middle = true};
    const Capsule edge{{0.0, 0.0}, {8.0, 0.0}, 0.0};
    CHECK(kick_at(sling, edge, {4.0, 1.0}, 1.0) == 2.0);
    CHECK(kick_at(sling, edge, {2.0, 1.0}, 1.0) == 1.5);
    CHECK(kick_at(sling, edge, {0.0, 1.0}, 1.0) == 0.0);
    CHECK(kick_at(sling, edge, {9.0, 1.0}, 1.0) == 0.0);
    CHECK(kick_at(Material{}, edge, {4.0, 1.0}, 1.0) == 0.0);
}

TEST_CASE("a lowered edge lets balls pass until it is raised, in every solver") {
    for (const SolverKind kind : solvers_available()) {
        CAPTURE(name(kind));
        World world = above_an_edge({}, 0.0, 2.0);
        set_side(world, world.capsules().id[0], Side::none);
        Solver solver({.kind = kind});
        for (int tick = 0; tick < 200; ++tick)
            solver.tick(world);
        CHECK(world.ledger().ball_edge_collisions == 0);
        CHECK(world.balls().position[0].y < -2.0);
        set_side(world, world.capsules().id[0], Side::both);
        world.edit_balls().velocity[0].y = 2.0;
        for (int tick = 0; tick < 200; ++tick)
            solver.tick(world);
        CHECK(world.ledger().ball_edge_collisions == 1);
        CHECK(world.balls().position[0].y < -1.0);
    }
}

TEST_CASE("a ball that rests on an edge falls when the edge is lowered, in every solver") {
    for (const SolverKind kind : solvers_available()) {
        CAPTURE(name(kind));
        World world = above_an_edge({.restitution = 0.2}, 0.0, 0.0);
        world.edit_definition().model.gravity = Vec2{0.0, -10.0};
        world.edit_balls().velocity[0].x = 0.0;
        Solver solver({.kind = kind});
        for (int tick = 0; tick < 300; ++tick)
            solver.tick(world);
        CHECK(world.balls().position[0].y == doctest::Approx(1.0).epsilon(0.02));
        set_side(world, world.capsules().id[0], Side::none);
        for (int tick = 0; tick < 100; ++tick)
            solver.tick(world);
        CHECK(world.balls().position[0].y < -3.0);
    }
}
