#include "physics/event/rest/cloth_phases.h"

#include <doctest/doctest.h>

#include "physics/support/event_parts.h"
#include "physics/support/scenes.h"

using namespace carom;

TEST_CASE("cloth phases: a struck ball slips, rolls, then rests") {
    World world = scenes::empty();
    world.edit_definition().model.spin = 0.4;
    world.edit_definition().model.cloth = Cloth{};
    add_ball(world, {.velocity = {1.0, 0.0}, .radius = 0.5, .roll = Vec2{}});
    EventParts parts(world);
    parts.cloth.begin_phase(0);
    REQUIRE(parts.balls[0].line.motion == Motion::slipping);
    for (const Motion next : {Motion::rolling, Motion::still}) {
        const auto end = parts.cloth.end_of_phase(0);
        REQUIRE(end);
        CHECK(parts.cloth.is_of_this_cloth(parts.balls.trajectory(0)));
        parts.scene.now = *end;
        parts.cloth.end_phase(0);
        CHECK(parts.balls[0].line.motion == next);
        // A solid ball rolls at 5/7 of the speed with which it started to slip.
        if (next == Motion::rolling)
            CHECK(parts.balls[0].line.velocity.x == doctest::Approx(5.0 / 7.0).epsilon(1e-12));
    }
    CHECK(!parts.cloth.end_of_phase(0));
    CHECK(Vec2(parts.balls[0].line.velocity) == Vec2{});
}

TEST_CASE("cloth phases: an edge takes the component of a roll that turns the ball into it") {
    World world = scenes::empty();
    world.edit_definition().model.spin = 0.4;
    world.edit_definition().model.cloth = Cloth{};
    add_capsule(world, {{0.0, -5.0}, {0.0, 5.0}, 0.0}, 0);
    add_ball(world,
             {.position = {0.5, 0.0}, .velocity = {0.0, 1.0}, .radius = 0.5, .roll = Vec2{-1, 1}});
    EventParts parts(world);
    parts.cloth.begin_phase(0);
    CHECK(parts.balls[0].line.velocity.x == 0.0);
    CHECK(parts.balls.curve(0).acceleration.x == 0.0);
    CHECK(parts.balls[0].line.motion == Motion::rolling);
}
