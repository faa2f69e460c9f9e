#include "game/pool/table_places.h"

#include <doctest/doctest.h>

#include "game/support/shipped.h"

using namespace carom;

TEST_CASE("table places: the head spot is on the head string, and the foot spot beyond it") {
    const Scene scene = test::shipped_level("eight-ball");
    const Vec2 head = head_spot(scene);
    CHECK(head.x == doctest::Approx(-0.635));
    CHECK(is_beyond_string(scene, head + 0.001 * rack_of(scene).toward));
    CHECK_FALSE(is_beyond_string(scene, head - 0.001 * rack_of(scene).toward));
    CHECK(is_beyond_string(scene, rack_of(scene).foot));
}

TEST_CASE("table places: a ball can be placed on the cloth, and not in a cushion or a pocket") {
    const Scene scene = test::shipped_level("eight-ball");
    const double radius = scene.world.balls().radius[0];
    CHECK(is_on_table(scene, scene.world, {0.0, 0.0}, radius));
    CHECK(is_on_table(scene, scene.world, {0.0, 0.5}, radius));
    CHECK_FALSE(is_on_table(scene, scene.world, {0.4, 0.635}, radius));
    CHECK_FALSE(is_on_table(scene, scene.world, {0.4, 2.0}, radius));
    const Capsule& pocket = scene.world.zones()[scene.pool.pockets[0]].shape;
    CHECK_FALSE(is_on_table(scene, scene.world, pocket.start, radius));
}

TEST_CASE("table places: the nearest free place is in the direction asked for, or opposite") {
    const Scene scene = test::shipped_level("eight-ball");
    World world = scene.world;
    for (Vec2& position : world.edit_balls().position)
        position = {100.0, 0.0};
    const double radius = world.balls().radius[0];
    CHECK(free_place(world, {0.0, 0.0}, {1.0, 0.0}, radius) == Vec2{0.0, 0.0});
    world.edit_balls().position[1] = {0.0, 0.0};
    const Vec2 beside = free_place(world, {0.0, 0.0}, {1.0, 0.0}, radius);
    CHECK(beside.y == 0.0);
    CHECK(beside.x >= 2.0 * radius);
    CHECK(beside.x < 2.1 * radius);
    // A ball as large as the whole search in that direction.
    world.edit_balls().position[1] = {19.0 * radius, 0.0};
    world.edit_balls().radius[1] = 18.5 * radius;
    CHECK(free_place(world, {0.0, 0.0}, {1.0, 0.0}, radius).x < 0.0);
}
