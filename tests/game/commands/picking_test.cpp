#include "game/commands/picking.h"

#include <doctest/doctest.h>

#include "game/support/scenes.h"

using namespace carom;
using carom::test::ball_at_rest;
using carom::test::busy_box;
using carom::test::rainy_torus;

TEST_CASE("the ball under the pointer is picked") {
    World world = busy_box().world;
    CHECK(ball_at(world, {8.5, 8.0}, 0.0) == BallId{0});
    CHECK(ball_at(world, {9.5, 8.0}, 0.0) == std::nullopt);
    CHECK(ball_at(world, {9.5, 8.0}, 0.6) == BallId{0});
    CHECK(ball_at(world, {10.51, 8.0}, 2.0) == BallId{1});
}

TEST_CASE("among overlapping balls the nearest centre is picked, then the lower id") {
    World world;
    world.edit_definition().kinds = {Kind{}};
    add_ball(world, ball_at_rest({0.0, 0.0}));
    add_ball(world, ball_at_rest({0.5, 0.0}));
    add_ball(world, ball_at_rest({0.5, 0.0}));
    CHECK(ball_at(world, {0.4, 0.0}, 0.0) == BallId{1});
    CHECK(ball_at(world, {0.1, 0.0}, 0.0) == BallId{0});
}

TEST_CASE("on a torus, picking reaches across a side") {
    World world = rainy_torus().world;
    world.edit_balls().position[0] = {0.2, 15.0};
    CHECK(ball_at(world, {39.8, 15.0}, 0.0) == BallId{0});
    CHECK(edge_at(world, {-14.5, 53.6}, 0.0) == CapsuleId{1});
}

TEST_CASE("ends of edges, and edges, are picked by distance") {
    const World world = busy_box().world;
    CHECK(edge_end_at(world, {24.3, 4.0}, 0.0) == EdgeEnd{CapsuleId{4}, false});
    CHECK(edge_end_at(world, {34.0, 7.2}, 0.0) == EdgeEnd{CapsuleId{4}, true});
    CHECK(edge_end_at(world, {29.0, 5.5}, 0.5) == std::nullopt);
    CHECK(edge_at(world, {29.0, 5.5}, 0.5) == CapsuleId{4});
    CHECK(edge_at(world, {20.0, 15.0}, 0.5) == std::nullopt);
}

TEST_CASE("a joint is all edge ends at one position") {
    const World world = busy_box().world;
    CHECK(joint(world, {CapsuleId{6}, false}) ==
          std::vector<EdgeEnd>{{CapsuleId{5}, true}, {CapsuleId{6}, false}});
    CHECK(joint(world, {CapsuleId{4}, false}) == std::vector<EdgeEnd>{{CapsuleId{4}, false}});
}

TEST_CASE("dragging a joint moves every edge that meets there") {
    const World world = busy_box().world;
    const EdgeGrip grip = grip_joint(world, {CapsuleId{5}, true}, {30.1, 20.0});
    const auto commands = carry(world, grip, {31.1, 22.0});
    REQUIRE(commands.size() == 2);
    const auto& first = std::get<command::HoldCapsule>(commands[0]);
    const auto& second = std::get<command::HoldCapsule>(commands[1]);
    CHECK(first.start_target == Vec2{25.0, 24.0});
    CHECK(first.end_target == Vec2{31.0, 22.0});
    CHECK(second.start_target == first.end_target);
    CHECK(second.end_target == Vec2{36.0, 25.0});
    CHECK(drop(world, grip).empty());
    World held = world;
    for (const Command& command : commands)
        execute(held, command);
    CHECK(drop(held, grip).size() == 2);
    CHECK(std::holds_alternative<command::PlaceCapsule>(place(world, grip, {0.0, 0.0})[1]));
}

TEST_CASE("dragging a whole edge moves the joined ends of its neighbours") {
    const World world = busy_box().world;
    const EdgeGrip grip = grip_edge(world, CapsuleId{6}, {33.0, 22.0});
    const auto commands = carry(world, grip, {33.0, 21.0});
    REQUIRE(commands.size() == 2);
    const auto& neighbour = std::get<command::HoldCapsule>(commands[0]);
    const auto& edge = std::get<command::HoldCapsule>(commands[1]);
    CHECK(neighbour.start_target == Vec2{25.0, 24.0});
    CHECK(neighbour.end_target == Vec2{30.0, 19.0});
    CHECK(edge.start_target == Vec2{30.0, 19.0});
    CHECK(edge.end_target == Vec2{36.0, 24.0});
}

TEST_CASE("a peg moves as a whole") {
    World world = busy_box().world;
    const CapsuleId peg = add_capsule(world, {{20.0, 25.0}, {20.0, 25.0}, 1.0}, 0);
    const EdgeGrip grip = grip_joint(world, {peg, false}, {20.0, 25.0});
    const auto commands = carry(world, grip, {21.0, 25.0});
    REQUIRE(commands.size() == 1);
    CHECK(std::get<command::HoldCapsule>(commands[0]).start_target == Vec2{21.0, 25.0});
    CHECK(std::get<command::HoldCapsule>(commands[0]).end_target == Vec2{21.0, 25.0});
}

TEST_CASE("an edge that vanishes is released") {
    World world = busy_box().world;
    const EdgeGrip grip = grip_joint(world, {CapsuleId{5}, true}, {30.0, 20.0});
    remove_capsule(world, CapsuleId{5});
    CHECK(carry(world, grip, {31.0, 22.0}).size() == 1);
}

TEST_CASE("stepping from ball to ball is cyclic") {
    World world = busy_box().world;
    remove_ball(world, BallId{4});
    CHECK(next_ball(world, std::nullopt) == BallId{0});
    CHECK(next_ball(world, std::nullopt, true) == BallId{8});
    CHECK(next_ball(world, BallId{3}) == BallId{5});
    CHECK(next_ball(world, BallId{4}) == BallId{5});
    CHECK(next_ball(world, BallId{4}, true) == BallId{3});
    CHECK(next_ball(world, BallId{8}) == BallId{0});
    CHECK(next_ball(world, BallId{0}, true) == BallId{8});
    world.edit_balls() = {};
    CHECK(next_ball(world, BallId{0}) == std::nullopt);
}
