#include "physics/event/hybrid_cluster.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "physics/event/motion/event_memory.h"
#include "physics/solver.h"
#include "physics/support/open_air.h"
#include "physics/support/scenes.h"

using namespace carom;
using open_air::add_floor;
using open_air::balls;

namespace {

std::vector<BallId> cluster_of(const World& world) {
    HybridCluster cluster;
    cluster.find(world);
    std::vector<BallId> ids;
    for (std::size_t i = 0; i < world.balls().size(); ++i)
        if (cluster.has_ball(i)) ids.push_back(world.balls().id[i]);
    return ids;
}

}  // namespace

TEST_CASE(
    "hybrid cluster: it is the dense balls, and everything that could meet them within a tick") {
    // In a tick a ball moves as far as its speed takes it, and 0.001 by its fall.
    struct Row {
        const char* what;
        std::vector<double> x;      // of balls on a line
        std::vector<double> speed;  // along it
        std::vector<BallId> dense;
        std::vector<BallId> cluster;
    };
    const std::vector<double> still(6, 0.0);
    const Row rows[] = {
        {"none", {0.0, 1.0}, still, {}, {}},
        {"a removed ball", {0.0, 1.0}, still, balls({7}), {}},
        {"one alone", {0.0, 1.1}, still, balls({0}), balls({0})},
        {"touching balls", {0.0, 1.0, 2.0, 3.1}, still, balls({0}), balls({0, 1, 2})},
        {"from the middle", {0.0, 1.0, 2.0, 3.1}, still, balls({1}), balls({0, 1, 2})},
        {"two clusters", {0.0, 1.0, 5.0, 6.0, 9.0}, still, balls({1, 2}), balls({0, 1, 2, 3})},
        {"a ball that comes", {0.0, 1.0, 2.1}, {0.0, 0.0, -20.0}, balls({0}), balls({0, 1, 2})},
        {"a ball too slow to come", {0.0, 1.0, 2.1}, {0.0, 0.0, -9.0}, balls({0}), balls({0, 1})},
        {"a ball between two", {0.0, 1.1, 2.2}, {0.0, -20.0, 0.0}, balls({0}), balls({0, 1, 2})},
        {"a dense ball that is fast", {0.0, 1.5}, {60.0, 0.0}, balls({0}), balls({0, 1})},
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        World world = open_air::make(0.5);
        for (std::size_t i = 0; i < row.x.size(); ++i)
            add_ball(world, {.position = {row.x[i], 0.0}, .velocity = {row.speed[i], 0.0}});
        edit_event_memory(world).clustered = row.dense;
        CHECK(cluster_of(world) == row.cluster);
    }

    // Across the seam of a torus; only kinds that collide; through a held edge.
    World torus = open_air::make(0.5);
    torus.edit_definition().model.wrap = Box{{0.0, 0.0}, {20.0, 20.0}};
    for (const double x : {0.4, 19.4, 10.0})
        add_ball(torus, {.position = {x, 5.0}, .velocity = {}});
    edit_event_memory(torus).clustered = balls({0});
    CHECK(cluster_of(torus) == balls({0, 1}));

    World layers = open_air::make(0.5);
    layers.edit_definition().kinds.push_back(layers.kinds()[0]);
    layers.edit_definition().model.filtered = true;
    layers.edit_definition().meets = {1, 0, 1, 0, 1, 1, 1, 1, 0};
    add_ball(layers, {.kind = 0, .position = {0.0, 0.0}, .velocity = {}});
    add_ball(layers, {.kind = 1, .position = {0.5, 0.0}, .velocity = {}});
    edit_event_memory(layers).clustered = balls({0});
    CHECK(cluster_of(layers) == balls({0}));

    World hand = open_air::make(0.5);
    const CapsuleId blade = add_capsule(hand, {{0.0, 1.0}, {9.0, 1.0}, 0.1}, 0);
    for (const double x : {0.0, 4.0, 8.0, 20.0})
        add_ball(hand, {.position = {x, 0.0}, .velocity = {}});
    edit_event_memory(hand).clustered = balls({0});
    CHECK(cluster_of(hand) == balls({0}));
    hand.edit_held_capsules().push_back({blade, {0.0, 0.5}, {9.0, 0.5}});
    CHECK(cluster_of(hand) == balls({0, 1, 2}));
}

TEST_CASE(
    "hybrid cluster: a ball returns when nothing presses it on another and it overlaps nothing") {
    struct Row {
        const char* what;
        double gap;    // of two balls side by side in the air
        double apart;  // speed of the second
        bool comes_back;
    };
    const Row rows[] = {
        {"in flight", 0.1, 0.0, true},
        {"that touches, and is not pressed", 1e-4, 0.0, true},
        {"that overlaps", -0.01, 0.0, false},
        {"that leaves an overlap", -0.01, 3.0, true},
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        World world = open_air::make(0.5);
        add_ball(world, {.position = {0.0, 9.0}, .velocity = {}});
        add_ball(world, {.position = {1.0 + row.gap, 9.0}, .velocity = {row.apart, 0.0}});
        edit_event_memory(world).clustered = balls({0, 1});
        Solver solver({.kind = SolverKind::event});
        solver.tick(world);
        CHECK(event_memory(world).clustered.empty() == row.comes_back);
        if (!row.comes_back) continue;
        // On an exact trajectory, whatever tick it ends in.
        const Vec2 place = world.balls().position[1];
        const Vec2 velocity = world.balls().velocity[1];
        for (int i = 0; i < 50; ++i)
            solver.tick(world);
        CHECK(event_memory(world).clustered.empty());
        CHECK(world.balls().position[1].x == doctest::Approx(place.x + 0.5 * velocity.x));
        const double fallen = place.y + 0.5 * velocity.y - 5.0 * 0.25;
        CHECK(std::abs(world.balls().position[1].y - fallen) < 1e-13 * 9.0);
    }
    // A ball pressed into the floor stays in the cluster until it leaves the floor.
    World world = open_air::make(0.5);
    add_floor(world);
    add_ball(world, {.position = {0.0, 0.49}, .velocity = {}});
    edit_event_memory(world).clustered = balls({0});
    Solver solver({.kind = SolverKind::event});
    solver.tick(world);
    CHECK(event_memory(world).clustered == balls({0}));
    world.edit_balls().velocity[0] = {0.0, 3.0};
    for (int i = 0; i < 3; ++i)
        solver.tick(world);
    CHECK(event_memory(world).clustered.empty());
}

TEST_CASE("hybrid cluster: the choice of balls does not depend on their order") {
    World world = scenes::bucket(60, 0.5);
    Solver solver({.kind = SolverKind::event});
    while (event_memory(world).clustered.empty())
        solver.tick(world);
    const std::size_t count = world.balls().size();
    World turned = world;
    for (std::size_t i = 0; i < count; ++i) {
        turned.edit_balls().position[i] = world.balls().position[count - 1 - i];
        turned.edit_balls().velocity[i] = world.balls().velocity[count - 1 - i];
    }
    const auto number_there = [&](BallId id) {
        return BallId{static_cast<std::uint32_t>(count - 1 - number(id))};
    };
    edit_event_memory(turned).clustered.clear();
    for (std::size_t i = event_memory(world).clustered.size(); i-- > 0;)
        edit_event_memory(turned).clustered.push_back(
            number_there(event_memory(world).clustered[i]));
    std::vector<BallId> cluster = cluster_of(world);
    const std::vector<BallId> cluster_there = cluster_of(turned);
    std::ranges::reverse(cluster);
    std::ranges::transform(cluster, cluster.begin(), number_there);
    CHECK(cluster == cluster_there);
    CHECK_FALSE(cluster.empty());
}
