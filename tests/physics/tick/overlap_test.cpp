#include "physics/tick/overlap.h"

#include <cmath>

#include <doctest/doctest.h>

#include "physics/support/scenes.h"

using namespace carom;

TEST_CASE("overlap: of two balls in radii of the smaller one, negative where they are apart") {
    World world = scenes::empty();
    add_ball(world, {.position = {0.0, 0.0}, .radius = 1.0});
    add_ball(world, {.position = {1.25, 0.0}, .radius = 0.5});
    add_ball(world, {.position = {0.0, 2.0}, .radius = 0.5});
    CHECK(relative_overlap(world, 0, 1) == 0.5);
    CHECK(relative_overlap(world, 1, 0) == 0.5);
    CHECK(relative_overlap(world, 0, 2) == -1.0);
}

TEST_CASE("overlap: with an edge in radii of the ball") {
    World world = scenes::empty();
    add_ball(world, {.position = {0.0, 1.0}, .radius = 1.0});
    CHECK(relative_overlap(world, 0, Capsule{{-2.0, 0.0}, {2.0, 0.0}, 0.25}) == 0.25);
    CHECK(relative_overlap(world, 0, Capsule{{-2.0, -1.0}, {2.0, -1.0}, 0.5}) == -0.5);
}

TEST_CASE("overlap: on a torus the nearest images of two balls count") {
    World world = scenes::empty();
    world.edit_definition().model.wrap = Box{{0.0, 0.0}, {10.0, 8.0}};
    add_ball(world, {.position = {0.25, 0.25}, .radius = 0.5});
    add_ball(world, {.position = {9.75, 7.75}, .radius = 0.5});
    add_ball(world, {.position = {5.0, 4.0}, .radius = 0.5});
    CHECK(relative_overlap(world, 0, 1) == doctest::Approx(2.0 - 2.0 * std::sqrt(0.5)));
    CHECK(relative_overlap(world, 0, 2) < 0.0);
}
