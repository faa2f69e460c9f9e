#include <doctest/doctest.h>

#include <cmath>

#include "physics/solver.h"
#include "physics/support/scenes.h"

// Under `contact`, a bar that moved many radii in a substep was held back in front of every ball,
// as if it could not push it: the ball took a part of the bar's speed, less with every push, and
// came to a stop.

using namespace carom;

namespace {

// The speed of a ball that a bar has pushed again and again, to and fro.
double speed_after_pushes(SolverKind kind) {
    World world = scenes::empty();
    world.edit_definition().rate = 60.0;
    world.edit_definition().materials[0].restitution = 0.5;
    scenes::add_walls(world, {{0.0, 0.0}, {100.0, 40.0}});
    const CapsuleId bar = add_capsule(world, {{10.0, 5.0}, {10.0, 35.0}, 0.5}, 0);
    add_ball(world, {.position = {30.0, 20.0}, .velocity = {-40.0, 0.0}, .radius = 1.0});
    Solver solver({.kind = kind});
    for (int tick = 0; tick < 200; ++tick) {
        const double x = tick / 2 % 2 == 0 ? 60.0 : 10.0;
        world.edit_held_capsules() = {
            {.id = bar, .start_target = {x, 5.0}, .end_target = {x, 35.0}}};
        solver.tick(world);
    }
    return length(world.balls().velocity[0]);
}

}  // namespace

TEST_CASE("contact: a fast bar pushes a ball as fast as under event, however often") {
    const double truth = speed_after_pushes(SolverKind::event);
    CHECK(truth > 1000.0);
    CHECK(speed_after_pushes(SolverKind::contact) == doctest::Approx(truth).epsilon(0.01));
}
