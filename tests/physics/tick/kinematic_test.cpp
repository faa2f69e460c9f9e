#include "physics/tick/kinematic.h"

#include <doctest/doctest.h>

#include "physics/support/scenes.h"

using namespace carom;

namespace {

// A horizontal edge from 0,0 to 4,0, whose end is dragged towards 4,2.
World world_with_held_edge() {
    World world = scenes::empty();
    const CapsuleId id = add_capsule(world, {{0, 0}, {4, 0}, 0.5}, 0);
    world.edit_held_capsules().push_back({.id = id, .start_target = {0, 0}, .end_target = {4, 2}});
    return world;
}

HeldEdge aimed(const World& world, double per_second) {
    std::vector<HeldEdge> edges;
    list_kinematic_edges(world, edges);
    REQUIRE(edges.size() == 1);
    aim(edges[0], world, per_second);
    return edges[0];
}

}  // namespace

TEST_CASE("kinematic edge: it moves its share of the displacement, and no further once stopped") {
    const World world = world_with_held_edge();
    HeldEdge edge = aimed(world, 10.0);
    CHECK(edge.end_velocity == Vec2{0, 20});
    CHECK(shape_at(edge, world, 0.05).end == Vec2{4, 1});
    edge.share = 0.5;
    CHECK(shape_at(edge, world, 0.05).end == Vec2{4, 0.5});
    edge.stopped_at = 0.025;
    CHECK(shape_at(edge, world, 0.05).end == Vec2{4, 0.25});
    CHECK(shape_at(edge, world, 0.0125).end == Vec2{4, 0.125});
}

TEST_CASE(
    "kinematic edge: its surface velocity is that of the nearest point of its spine, until it "
    "stops") {
    const World world = world_with_held_edge();
    HeldEdge edge = aimed(world, 1.0);
    const Capsule& shape = world.capsules().shape[0];
    CHECK(surface_velocity(edge, shape, {2, 3}) == Vec2{0, 1});
    CHECK(surface_velocity(edge, shape, {9, 0}) == Vec2{0, 2});
    edge.share = 0.25;
    CHECK(surface_velocity(edge, shape, {9, 0}) == Vec2{0, 0.5});
    edge.stopped_at = 0.0;
    CHECK(surface_velocity(edge, shape, {9, 0}) == Vec2{});
}

TEST_CASE("kinematic edge: found by its capsule; one without a capsule is not listed") {
    World world = world_with_held_edge();
    world.edit_held_capsules().push_back({.id = CapsuleId{99}});
    std::vector<HeldEdge> edges;
    list_kinematic_edges(world, edges);
    CHECK(edges.size() == 1);
    CHECK(find_edge(std::span<HeldEdge>(edges), 0) == &edges[0]);
    CHECK(find_edge(std::span<HeldEdge>(edges), 1) == nullptr);
}

TEST_CASE("a held ball is immovable, and takes the shorter way on a torus") {
    World world = scenes::empty();
    world.edit_definition().model.wrap = Box{{0, 0}, {10, 10}};
    const BallId id = add_ball(world, {.position = {9, 5}});
    const HeldBall held{.id = id, .target = {1, 5}};
    CHECK(displacement_to_target(world, held, {9, 5}) == Vec2{2, 0});
    world.edit_definition().model.wrap.reset();
    CHECK(displacement_to_target(world, held, {9, 5}) == Vec2{-8, 0});
    world.edit_held_balls().push_back(held);
    std::vector<double> inverse_mass{1.0};
    make_held_balls_immovable(world, inverse_mass);
    CHECK(inverse_mass[0] == 0.0);
}

TEST_CASE("kinematic edge: when it stops, predictions made before become void") {
    HeldEdge edge;
    const std::uint32_t before = edge.version;
    CHECK_FALSE(edge.is_stopped());
    edge.stop(0.0);
    CHECK(edge.is_stopped());
    CHECK(edge.version != before);
}
