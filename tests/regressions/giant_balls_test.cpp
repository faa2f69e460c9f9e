#include <cmath>

#include <doctest/doctest.h>

#include "physics/event/motion/event_memory.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"

// Oversized balls are in no cell of the solver `event`. The search for the bodies that touch a ball
// forgot them: as supports, and beyond the seam of a torus.

using namespace carom;

TEST_CASE("event: a small ball comes to rest on an oversized ball") {
    World world = scenes::empty();
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
    world.edit_definition().kinds[0].restitution = 0.5;
    world.edit_definition().materials[0].restitution = 0.5;
    add_capsule(world, {{-500.0, 0.0}, {500.0, 0.0}, 0.0}, 0);
    add_ball(world, {.position = {0.0, 100.0}, .radius = 100.0, .mass = 1e6, .restitution = 0.5});
    add_ball(world, {.position = {0.0, 202.0}, .radius = 1.0, .mass = 1.0, .restitution = 0.5});
    Solver solver({.kind = SolverKind::event});
    for (int i = 0; i < 600; ++i)
        solver.tick(world);
    const std::uint64_t bounces = world.ball_ball_collisions();
    CHECK(bounces > 5);
    REQUIRE(event_memory(world).trajectories.lines.size() == 2);
    CHECK(event_memory(world).trajectories.lines[1].motion == Motion::resting);
    CHECK(world.balls().position[1].y == doctest::Approx(201.0).epsilon(1e-12));
    for (int i = 0; i < 600; ++i)
        solver.tick(world);
    CHECK(world.ball_ball_collisions() == bounces);
}

// A large ball meets two small ones at once, with and without the seam of the torus between it and
// one of them.
TEST_CASE("event: a large ball meets two small ones at once across the seam of a torus") {
    const auto after = [](double shift) {
        World world = scenes::empty();
        world.edit_definition().model.wrap = Box{{0.0, 0.0}, {100.0, 100.0}};
        const auto place = [&](double x, double y) { return Vec2{std::fmod(x + shift, 100.0), y}; };
        add_ball(world,
                 {.position = place(50.0, 30.0), .velocity = {0, 10}, .radius = 20.0, .mass = 40});
        for (const double side : {-1.0, 1.0})
            add_ball(world,
                     {.position = place(50.0 + side * 10.0, 60.0), .radius = 1.0, .mass = 1.0});
        Solver solver({.kind = SolverKind::event});
        for (int i = 0; i < 240; ++i)
            solver.tick(world);
        CHECK(world.ball_ball_collisions() == 2);
        return world;
    };
    const World whole = after(0.0);
    CHECK(std::abs(whole.balls().velocity[0].x) < 1e-12);
    for (const double shift : {43.0, 55.0, 71.0}) {
        CAPTURE(shift);
        const World parted = after(shift);
        for (std::size_t i = 0; i < 3; ++i)
            CHECK(length(parted.balls().velocity[i] - whole.balls().velocity[i]) < 1e-9);
    }
}
