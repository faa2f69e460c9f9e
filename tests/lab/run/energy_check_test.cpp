#include "lab/run/energy_check.h"

#include <doctest/doctest.h>

#include <optional>

#include "lab/run/promise.h"

using namespace carom;

// Regression: the baseline took over the rounding of the potential energy under the gravity before,
// and a ball was said to have gained all of its kinetic energy.
TEST_CASE("when a huge gravity goes off, the energy that is left is the baseline") {
    World world;
    world.edit_definition().kinds = {{}};
    world.edit_definition().model.gravity = Vec2{1e18, 0.0};
    add_ball(world, {.position = {97.0, 50.0}, .velocity = {0.0, -1.25}});
    EnergyCheck check(promise_of(SolverKind::event), true, world);
    world.edit_definition().model.gravity = std::nullopt;
    check.take_over(world);
    check.remember(world);
    CHECK_FALSE(check.check(world, {}, true, false));
    world.edit_balls().velocity[0] = {0.0, -1.26};
    CHECK(check.check(world, {}, true, false));
}
