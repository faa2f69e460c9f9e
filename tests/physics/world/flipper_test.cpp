#include "physics/world/flipper.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "geometry/closest.h"
#include "geometry/elementary.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"

using namespace carom;

namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

World with_flipper(double rate) {
    World world = scenes::empty();
    world.edit_definition().rate = rate;
    const auto [sine, cosine] = sin_cos(-31.0 * degree);
    Flipper flipper{.length = 0.07, .rest = {cosine, sine}, .sweep = 51.0 * degree};
    const Vec2 pivot{0.147, 0.13};
    flipper.capsule = add_capsule(world, {pivot, flipper_end(flipper, pivot, 0.0), 0.009}, 0);
    world.edit_flippers().push_back(flipper);
    return world;
}

}  // namespace

TEST_CASE("a flipper is up after its rise, and back after its fall, whatever the tick") {
    for (const double rate : {500.0, 1000.0, 2000.0, 8000.0}) {
        CAPTURE(rate);
        World world = with_flipper(rate);
        Solver solver({.kind = SolverKind::swept});
        world.edit_flippers()[0].is_pressed = true;
        const auto ticks = [&](double seconds) {
            return static_cast<int>(std::lround(seconds * rate));
        };
        for (int i = 0; i < ticks(0.01); ++i)
            solver.tick(world);
        CHECK(world.flippers()[0].progress == doctest::Approx(0.25).epsilon(1e-9));
        CHECK(world.flippers()[0].rate == doctest::Approx(50.0).epsilon(1e-9));
        for (int i = 0; i < ticks(0.01) && world.flippers()[0].progress < 1.0; ++i)
            solver.tick(world);
        CHECK(world.flippers()[0].progress == 1.0);
        // It recoils from its stop, by a few degrees, and lies against it after 30 ms.
        double lowest = 1.0;
        for (int i = 0; i <= ticks(0.03); ++i) {
            solver.tick(world);
            lowest = std::min(lowest, world.flippers()[0].progress);
        }
        CHECK(lowest < 0.99);
        CHECK(lowest > 0.93);
        CHECK(world.flippers()[0].progress == 1.0);
        CHECK(world.flippers()[0].rate == 0.0);
        const Capsule& shape = world.capsules().shape[0];
        CHECK(shape.end == flipper_end(world.flippers()[0], shape.start, 1.0));
        world.edit_flippers()[0].is_pressed = false;
        for (int i = 0; i <= ticks(0.08); ++i)
            solver.tick(world);
        CHECK(world.flippers()[0].progress == 0.0);
        CHECK(shape.end == flipper_end(world.flippers()[0], shape.start, 0.0));
        CHECK(world.held_capsules().empty());
    }
}

TEST_CASE("a flipper keeps its length and continues from its position when the button changes") {
    World world = with_flipper(1000.0);
    Solver solver({.kind = SolverKind::swept});
    double before = 0.0;
    double most = 0.0;
    for (int tick = 0; tick < 300; ++tick) {
        world.edit_flippers()[0].is_pressed = (tick / 7) % 2 == 0;
        solver.tick(world);
        const Capsule& shape = world.capsules().shape[0];
        CHECK(length(shape.end - shape.start) == doctest::Approx(0.07).epsilon(1e-12));
        most = std::max(most, std::abs(world.flippers()[0].progress - before));
        before = world.flippers()[0].progress;
    }
    // Never faster than at the end of its rise: a tenth of the way in a thousandth of a second.
    CHECK(most > 0.02);
    CHECK(most < 0.101);
}

TEST_CASE("a flipper without its capsule is removed too") {
    World world = with_flipper(1000.0);
    world.edit_flippers()[0].is_pressed = true;
    remove_capsule(world, world.flippers()[0].capsule);
    CHECK(world.flippers().empty());
    Solver solver({.kind = SolverKind::swept});
    solver.tick(world);
    CHECK(world.held_capsules().empty());
}

TEST_CASE("a motorised edge throws like a moving wall, in every solver") {
    for (const SolverKind kind : solvers_available()) {
        CAPTURE(name(kind));
        World world = scenes::empty();
        world.edit_definition().rate = 1000.0;
        world.edit_definition().materials[0] = {.restitution = 0.8, .soften = 0.1};
        const CapsuleId wall = add_capsule(world, {{-5.0, 0.0}, {5.0, 0.0}, 0.0}, 0);
        const BallId ball =
            add_ball(world, {.kind = 0, .position = {0.0, 1.5}, .velocity = {3.0, -2.0}});
        Solver solver({.kind = kind});
        for (int tick = 0; tick < 200 && world.ledger().ball_edge_collisions == 0; ++tick) {
            const Vec2 step{0.0, 0.004};
            const Capsule shape = world.capsules().shape[0];
            world.edit_held_capsules() = {{wall, shape.start + step, shape.end + step, true}};
            solver.tick(world);
        }
        REQUIRE(world.ledger().ball_edge_collisions == 1);
        // The wall moves up at 4, the ball came down at 2: they approach at 6.
        const double leaves = 4.0 + 0.8 / (1.0 + 0.1 * 6.0) * 6.0;
        const Vec2 velocity = world.balls().velocity[*index_of(world, ball)];
        CHECK(velocity.x == doctest::Approx(3.0).epsilon(1e-9));
        CHECK(velocity.y == doctest::Approx(leaves).epsilon(1e-9));
    }
}

TEST_CASE("nothing passes a flipper, and no ball is launched faster than its tip allows") {
    // Balls fall on all of the flipper, at any moment of its rise.
    for (int place = 0; place < 24; ++place) {
        for (int moment = 0; moment < 12; ++moment) {
            CAPTURE(place);
            CAPTURE(moment);
            World world = with_flipper(1000.0);
            world.edit_definition().model.gravity = Vec2{0.0, -0.793};
            world.edit_definition().kinds[0] = {.radius = 0.0135, .mass = 0.08};
            world.edit_definition().materials[0] = {.restitution = 0.8, .soften = 0.43};
            world.edit_definition().model.inelastic = true;
            const double x = 0.14 + 0.075 * place / 24.0;
            add_ball(world, {.kind = 0, .position = {x, 0.165}, .velocity = {0.0, -2.0}});
            Solver solver({.kind = SolverKind::swept});
            const Flipper& flipper = world.flippers()[0];
            const double fastest = 2.0 / flipper.rise * flipper.sweep * (0.07 + 0.009);
            for (int tick = 0; tick < 120; ++tick) {
                world.edit_flippers()[0].is_pressed = tick >= 3 * moment;
                solver.tick(world);
                const Vec2 position = world.balls().position[0];
                const Capsule& shape = world.capsules().shape[0];
                const Vec2 nearest = closest_point(shape.start, shape.end, position);
                REQUIRE(distance(nearest, position) > 0.0225 - 1e-6);
                // The fastest: a falling ball met by the tip at full speed.
                REQUIRE(length(world.balls().velocity[0]) < fastest + 0.8 * (fastest + 2.1));
            }
            CHECK(flipper.progress == 1.0);
        }
    }
}

TEST_CASE("a ball that rests on a flipper leaves at about the speed of its resting point") {
    World world = with_flipper(1000.0);
    world.edit_definition().model.gravity = Vec2{0.0, -0.793};
    world.edit_definition().kinds[0] = {.radius = 0.0135, .mass = 0.08};
    world.edit_definition().materials[0] = {.restitution = 0.0};
    const Capsule shape = world.capsules().shape[0];
    const Vec2 along = (shape.end - shape.start) / 0.07;
    const double lay = 0.05;
    add_ball(world, {.kind = 0,
                     .position = shape.start + along * lay + perpendicular(along) * 0.0225,
                     .restitution = 0.0});
    world.edit_definition().model.inelastic = true;
    world.edit_flippers()[0].is_pressed = true;
    Solver solver({.kind = SolverKind::swept});
    for (int tick = 0; tick < 25; ++tick)
        solver.tick(world);
    const double turning = 2.0 / world.flippers()[0].rise * world.flippers()[0].sweep;
    const double speed = length(world.balls().velocity[0]);
    // It rolls outwards on the way, so it leaves from further out.
    CHECK(speed > turning * lay * 0.95);
    CHECK(speed < turning * 0.079 * 1.1);
}
