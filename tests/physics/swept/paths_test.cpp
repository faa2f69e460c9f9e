#include "physics/swept/paths.h"

#include <cmath>

#include <doctest/doctest.h>

#include "physics/support/scenes.h"
#include "physics/swept/tolerances.h"

using namespace carom;

namespace {

// One ball of radius 1 at height 10 that rises at `speed`, gravity 10, ticks of a second.
World falling(double speed) {
    World world = scenes::empty();
    world.edit_definition().rate = 1.0;
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
    add_ball(world, {.position = {0.0, 10.0}, .velocity = {2.0, speed}});
    return world;
}

}  // namespace

TEST_CASE("swept paths: the chord begins and ends on the parabola") {
    World world = falling(3.0);
    const SweptSubstep step = swept_substep(world, world.tick_length() / 2);
    CHECK(step.duration == 0.5);
    SweptPaths paths(step);
    paths.begin_tick(world);
    paths.begin(world, 1.0);
    CHECK(paths.position_at(0, 0.0) == Vec2{0.0, 10.0});
    CHECK(paths.position_at(0, 0.5) == Vec2{1.0, 10.25});
    paths.finish(world);
    CHECK(world.balls().position[0] == Vec2{1.0, 10.25});
    CHECK(world.balls().velocity[0] == Vec2{2.0, -2.0});
}

TEST_CASE("swept paths: the velocity is the parabola's at the height of the chord") {
    const World world = falling(-3.0);
    const SweptSubstep step = swept_substep(world, world.tick_length());
    SweptPaths paths(step);
    paths.begin_tick(world);
    paths.begin(world, 1.0);
    for (const double now : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Vec2 velocity = paths.velocity_at(world, 0, now);
        const double energy = 0.5 * length_squared(velocity) + 10.0 * paths.position_at(0, now).y;
        CHECK(energy == doctest::Approx(0.5 * 13.0 + 100.0).epsilon(1e-14));
    }
}

TEST_CASE("swept paths: a ball that is pressed too often rests, or time stands still") {
    for (const bool is_elastic : {false, true}) {
        CAPTURE(is_elastic);
        World world = falling(3.0);
        world.edit_definition().model.inelastic = !is_elastic;
        const SweptSubstep step = swept_substep(world, world.tick_length());
        SweptPaths paths(step);
        paths.begin_tick(world);
        paths.begin(world, 1.0);
        paths.redirect(world, 0, 0.5, {1.0, 0.0});
        for (std::uint32_t i = 0; i < swept_tolerance::most_resting_impacts; ++i) {
            CHECK(!paths[0].is_frozen);
            paths.count_resting_impact(world, 0, {1.0, 0.0});
        }
        CHECK(paths[0].is_frozen);
        CHECK(paths.standing().size() == (is_elastic ? 1 : 0));
        CHECK(!paths.redirect(world, 0, 0.5, {1.0, 0.0}));
        const Vec2 there = paths.position_at(0, 0.5);
        CHECK(paths.position_at(0, 1.0) == there);
        paths.finish(world);
        CHECK(world.balls().position[0] == there);
        CHECK(world.balls().velocity[0] == (is_elastic ? Vec2{1.0, 0.0} : Vec2{}));
    }
}

TEST_CASE("swept paths: a ball on two supports feels what both leave of gravity") {
    const World world = falling(0.0);
    const SweptSubstep step = swept_substep(world, world.tick_length());
    SweptPaths paths(step);
    paths.begin_tick(world);
    paths.begin(world, 1.0);
    CHECK(paths.gravity_on(0) == Vec2{0.0, -10.0});
    const double half = std::sqrt(0.5);
    paths.rest_on(world, 0, {half, half});
    CHECK(paths.gravity_on(0).x == doctest::Approx(5.0));
    CHECK(paths.gravity_on(0).y == doctest::Approx(-5.0));
    paths.rest_on(world, 0, {-half, half});
    CHECK(paths.gravity_on(0) == Vec2{});
    paths.end_rest(0);
    CHECK(paths.gravity_on(0) == Vec2{0.0, -10.0});
    // A wall from above supports nothing.
    paths.rest_on(world, 0, {0.0, -1.0});
    CHECK(!paths[0].is_resting);
}
