#include "physics/event/impact/restitution.h"

#include <cmath>

#include <doctest/doctest.h>

#include "physics/event/motion/tolerances.h"
#include "physics/support/event_parts.h"
#include "physics/support/scenes.h"

using namespace carom;

namespace {

constexpr double usual = 0.5;
constexpr double gravity = 10.0;
constexpr double radius = 0.5;

World inelastic() {
    World world = scenes::empty();
    world.edit_definition().model.gravity = Vec2{0.0, -gravity};
    world.edit_definition().model.inelastic = true;
    world.edit_definition().kinds[0].restitution =
        world.edit_definition().materials[0].restitution = usual;
    return world;
}

// The approach speed after which the rebound rises so many radii.
double approach_for(double height) {
    return std::sqrt(2.0 * gravity * height * radius) / usual;
}

double on_floor(double height, bool is_alone) {
    World world = inelastic();
    add_capsule(world, {{-9.0, 0.0}, {9.0, 0.0}, 0.0}, 0);
    add_ball(
        world,
        {.position = {0.0, radius}, .velocity = {0.0, -approach_for(height)}, .radius = radius});
    EventParts parts(world);
    parts.cluster.begin(0, {0.0, EventKind::ball_edge, 0, 0, 0, 0});
    const Restitution<double> restitution(parts.scene, parts.balls, parts.kinematic, parts.cluster);
    return restitution.of(parts.cluster.contacts()[0], is_alone);
}

}  // namespace

TEST_CASE(
    "restitution: a rebound below the rest height is suppressed, except in simultaneous impacts") {
    CHECK(on_floor(1.01 * rest_height, true) == usual);
    CHECK(on_floor(0.99 * rest_height, true) == 0.0);
    CHECK(on_floor(0.99 * rest_height, false) == usual);
}

TEST_CASE(
    "restitution: low rebounds of two moving balls are suppressed only if they are pressed "
    "together") {
    // Both fall freely, so nothing presses them together; then the lower one slides on a floor.
    for (const bool is_carried : {false, true})
        for (const double factor : {0.99, 1.01}) {
            CAPTURE(is_carried);
            CAPTURE(factor);
            World world = inelastic();
            add_capsule(world, {{-9.0, 0.0}, {9.0, 0.0}, 0.0}, 0);
            const double speed = approach_for(factor * moving_rest_height);
            add_ball(world, {.position = {0.0, radius},
                             .velocity = {is_carried ? 1e-3 : 0.0, 0.0},
                             .radius = radius});
            add_ball(world, {.position = {0.0, 3.0 * radius},
                             .velocity = {is_carried ? 1e-3 : 0.0, -speed},
                             .radius = radius});
            EventParts parts(world);
            if (is_carried) parts.rest.settle(0);
            parts.cluster.begin(0, {0.0, EventKind::ball_ball, 0, 0, 1, 0});
            const Restitution<double> restitution(parts.scene, parts.balls, parts.kinematic,
                                                  parts.cluster);
            const double expected = is_carried && factor < 1.0 ? 1.0 : usual;
            CHECK(restitution.of(parts.cluster.contacts()[0], true) == expected);
        }
}
