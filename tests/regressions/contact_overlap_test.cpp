#include <algorithm>

#include <doctest/doctest.h>

#include "physics/solver.h"
#include "physics/support/scenes.h"

// What random scenes under `carom run --check` have shown of `contact`: bodies that went into one
// another, or through.

using namespace carom;

namespace {

double overlap(const World& world, std::size_t a, std::size_t b) {
    const Balls& balls = world.balls();
    return balls.radius[a] + balls.radius[b] - length(balls.position[a] - balls.position[b]);
}

World falling_world(double rate, double gravity) {
    World world = scenes::empty();
    world.edit_definition().rate = rate;
    world.edit_definition().model.gravity = Vec2{0.0, -gravity};
    world.edit_definition().model.inelastic = true;
    return world;
}

}  // namespace

// Regression: an impulse that rounding made moved the grain off its parabola by g h^2 / 2, which is
// more than its radius. The ball below, of a larger mass, kept to its own.
TEST_CASE("contact: a grain that falls with a ball stays on it") {
    for (const double gravity : {10.0, 2787.0, 3e5}) {
        CAPTURE(gravity);
        World world = falling_world(240.0, gravity);
        add_ball(world, {.position = {0.0, 0.1}, .radius = 0.7139059275258077, .mass = 1.6});
        add_ball(world, {.position = {0.0, 0.1 + 0.7139059275258077 + 0.0013332237826938615},
                         .radius = 0.0013332237826938615,
                         .mass = 5.6e-6});
        Solver solver({.kind = SolverKind::contact});
        for (int tick = 0; tick < 20; ++tick) {
            solver.tick(world);
            CHECK(overlap(world, 0, 1) < 5e-3 * 0.00133);
        }
    }
}

// A constraint lets balls fall g h^2 into what they land on. With four substeps that is ten times
// the radius of these grains.
TEST_CASE("contact: grains under a strong gravity land on a ball, and do not sink in") {
    World world = falling_world(60.0, 500.0);
    world.edit_definition().kinds[0].restitution = 0.0;
    world.edit_definition().materials[0].restitution = 0.0;
    add_capsule(world, {{-5.0, 0.0}, {5.0, 0.0}, 0.0}, 0);
    add_ball(world, {.position = {0.0, 1.0}, .radius = 1.0, .mass = 10.0, .restitution = 0.0});
    for (int i = 0; i < 4; ++i)
        add_ball(world, {.position = {0.0, 2.02 + 0.005 * i},
                         .radius = 0.002,
                         .mass = 1e-5,
                         .restitution = 0.0});
    Solver solver({.kind = SolverKind::contact});
    double deepest = 0.0;
    for (int tick = 0; tick < 60; ++tick) {
        solver.tick(world);
        for (std::size_t i = 1; i < 5; ++i)
            for (std::size_t j = 0; j < i; ++j)
                deepest = std::max(deepest, overlap(world, i, j));
    }
    CHECK(deepest < 0.75 * 0.002);
}

// Regression: the rule for balls too far through a one-way edge was applied to walls, if there was
// a one-way edge anywhere. Such a ball went through.
TEST_CASE("contact: a ball that starts inside a wall is stopped, though another edge is one-way") {
    World world = scenes::empty();
    world.edit_definition().model.one_way = true;
    world.edit_definition().model.inelastic = true;
    world.edit_definition().materials[0].restitution = 0.0;
    add_capsule(world, {{0.0, -10.0}, {0.0, 10.0}, 0.0}, 0);
    add_capsule(world, {{50.0, -10.0}, {50.0, 10.0}, 0.0}, 0, Side::left);
    add_ball(world, {.position = {0.45, 0.0}, .velocity = {-30.0, 5.0}, .radius = 1.0});
    Solver solver({.kind = SolverKind::contact});
    for (int tick = 0; tick < 10; ++tick) {
        solver.tick(world);
        CHECK(world.balls().position[0].x >= 0.45 - 1e-9);
    }
}

// Regression: whatever met a ball that starts inside another one was left to constraints alone, and
// sank in by nine tenths of its radius.
TEST_CASE("contact: balls meet one that starts inside another as they meet any") {
    World world = falling_world(60.0, 13.0);
    world.edit_definition().kinds[0].restitution = 0.5;
    add_capsule(world, {{-5.0, 0.0}, {5.0, 0.0}, 0.0}, 0);
    add_ball(world, {.position = {0.0, 0.75}, .radius = 0.75, .mass = 4.0, .restitution = 0.0});
    add_ball(world, {.position = {0.0, 1.35}, .radius = 0.75, .mass = 1e-4, .restitution = 0.0});
    add_ball(world, {.position = {0.01, 3.5},
                     .velocity = {0.0, -8.0},
                     .radius = 0.45,
                     .mass = 0.1,
                     .restitution = 0.0});
    Solver solver({.kind = SolverKind::contact});
    double deepest = 0.0;
    for (int tick = 0; tick < 60; ++tick) {
        solver.tick(world);
        deepest = std::max(deepest, overlap(world, 1, 2));
    }
    CHECK(deepest < 0.55 * 0.45);
}
