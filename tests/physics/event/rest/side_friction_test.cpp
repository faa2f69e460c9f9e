#include "physics/event/rest/side_friction.h"

#include <doctest/doctest.h>

#include "physics/solver.h"
#include "physics/support/event_parts.h"
#include "physics/support/scenes.h"

using namespace carom;

namespace {

constexpr double coefficient = 0.2;

World sliding(double speed) {
    World world = scenes::empty();
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
    world.edit_definition().model.inelastic = true;
    world.edit_definition().model.spin = 0.5;
    world.edit_definition().materials[0].friction = coefficient;
    add_capsule(world, {{-100.0, 0.0}, {100.0, 0.0}, 0.0}, 0);
    add_ball(world, {.position = {0.0, 0.5}, .velocity = {speed, 0.0}, .radius = 0.5});
    return world;
}

}  // namespace

TEST_CASE("side friction: a disc that slides rolls after v / 3 mu g, at two thirds of its speed") {
    EventParts parts(sliding(3.0));
    parts.rest.settle(0);
    REQUIRE(parts.balls[0].line.motion == Motion::sliding);
    CHECK(parts.balls.curve(0).acceleration.x == doctest::Approx(-coefficient * 10.0));
    const auto end = parts.friction.end_of_slip(0, 100.0);
    REQUIRE(end);
    CHECK(*end == doctest::Approx(parts.scene.now + 3.0 / (3.0 * coefficient * 10.0)));
    parts.scene.now = *end;
    const auto& changed = parts.transitions.handle(0);
    CHECK(changed == std::vector<std::uint32_t>{0});
    CHECK(parts.trajectories.spin(0).rolls);
    CHECK(parts.balls[0].line.velocity.x == doctest::Approx(2.0));
    CHECK(parts.trajectories.spin(0).spin * 0.5 == doctest::Approx(-2.0).epsilon(1e-9));
    // A rolling ball on a level floor needs no friction.
    CHECK(parts.balls.curve(0).acceleration.x == 0.0);
    CHECK(!parts.friction.end_of_slip(0, 100.0));
}

TEST_CASE("side friction: two supports brake a spin until it is gone, to the last bit") {
    for (int i = 1; i <= 50; ++i) {
        CAPTURE(i);
        World world = sliding(0.0);
        world.edit_tick() = 7;
        const double spin = 0.1 * i;
        world.edit_balls().spin[0] = spin;
        EventParts parts(world);
        parts.trajectories.put_to_rest(0, {}, {});
        parts.friction.brake(0, 0.7);
        const auto end = parts.friction.end_of_slip(0, 100.0);
        REQUIRE(end);
        // Spin times radius and inertia, divided by friction.
        CHECK(*end == doctest::Approx(parts.scene.now + spin * 0.5 * 0.5 / 0.7));
        parts.scene.now = *end;
        parts.friction.end_slip(0);
        CHECK(parts.trajectories.spin(0).spin == 0.0);
    }
}

// Regression: braking that ends within the rounding of time ended again and again, without end.
TEST_CASE("side friction: a spin of rounding's making is braked at once") {
    for (const double spin : {1e-12, 1e-15, -1e-18, 1e-300}) {
        CAPTURE(spin);
        World world = sliding(0.0);
        world.edit_tick() = 7000;
        world.edit_balls().spin[0] = spin;
        EventParts parts(world);
        parts.trajectories.put_to_rest(0, {}, {});
        parts.friction.brake(0, 0.7);
        const auto end = parts.friction.end_of_slip(0, 1000.0);
        REQUIRE(end);
        parts.scene.now = *end;
        parts.friction.end_slip(0);
        CHECK(parts.trajectories.spin(0).spin == 0.0);
    }
}

// A ball that falls between two pegs that rub comes to rest on both.
TEST_CASE("side friction: a ball between two pegs does not use up the work of a tick") {
    World world = scenes::empty();
    world.edit_definition().rate = 1000.0;
    world.edit_definition().model.gravity = Vec2{0.0, -0.793};
    world.edit_definition().model.inelastic = true;
    world.edit_definition().model.spin = 0.5;
    world.edit_definition().materials[0] = {.restitution = 0.4, .friction = 0.05};
    for (const double x : {0.305, 0.329})
        add_capsule(world, {{x, 0.39}, {x, 0.39}, 0.002}, 0);
    add_ball(world, {.position = {0.317, 0.3999}, .radius = 0.0135, .mass = 0.08});
    Solver solver({.kind = SolverKind::event});
    for (int i = 0; i < 2000; ++i)
        REQUIRE(solver.tick(world) == TickOutcome::done);
    CHECK(length(world.balls().velocity[0]) == 0.0);
    CHECK(world.balls().spin[0] == 0.0);
}
