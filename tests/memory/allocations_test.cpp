#include <functional>
#include <string>

#include <doctest/doctest.h>

#include "memory/counts.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"

using namespace carom;

namespace {

/// A scene, and the changes made to it before each tick.
struct Scene {
    const char* name;
    World world;
    std::function<void(World&)> before_tick = [](World&) {};
};

World heap() {
    World world = scenes::bucket(20, 0.0);
    world.edit_definition().model.spin = 0.5;
    world.edit_balls().spin.assign(world.balls().size(), 0.0);
    world.edit_definition().kinds[0].friction = world.edit_definition().materials[0].friction = 0.3;
    return world;
}

// Radii 1, 1/2 and 1/4.
World mixture() {
    World world = scenes::gas(150, 5);
    for (std::size_t i = 0; i < world.balls().size(); ++i)
        world.edit_balls().radius[i] *= 1.0 / static_cast<double>(1 << (i % 3));
    return world;
}

World dragged() {
    World world = scenes::bucket(30, 0.5);
    add_capsule(world, {{3.0, 30.0}, {17.0, 30.0}, 0.5}, 0);
    return world;
}

void drag(World& world) {
    const CapsuleId edge = world.capsules().id.back();
    const double height = 3.0 + static_cast<double>((world.tick() * 7) % 100) / 10.0;
    world.edit_held_capsules().assign(1, {edge, {3.0, height}, {17.0, height}});
}

std::vector<Scene> all_scenes() {
    std::vector<Scene> scenes;
    scenes.push_back({.name = "gas", .world = scenes::gas(200, 3)});
    scenes.push_back({.name = "gas on a torus", .world = scenes::gas(200, 4, true)});
    scenes.push_back({.name = "mixture", .world = mixture()});
    scenes.push_back({.name = "cradle", .world = scenes::cradle(7, 2, 0.0)});
    scenes.push_back({.name = "pile", .world = scenes::bucket(40, 0.3)});
    scenes.push_back({.name = "heap", .world = heap()});
    scenes.push_back({.name = "drag", .world = dragged(), .before_tick = drag});
    return scenes;
}

}  // namespace

// A solver is warm once it has computed these ticks before: then it has all the memory it needs.
TEST_CASE("a warmed-up scene allocates nothing in a tick") {
    constexpr int ticks = 120;
    for (const Scene& scene : all_scenes()) {
        for (const SolverKind kind : solvers_available()) {
            World world = scene.world;
            Solver solver({.kind = kind});
            std::size_t counted = 0;
            for (int round = 0; round < 2; ++round) {
                world = scene.world;
                counted = 0;
                for (int i = 0; i < ticks; ++i) {
                    scene.before_tick(world);
                    const std::size_t before = test::memory_counts.allocations;
                    solver.tick(world);
                    counted += test::memory_counts.allocations - before;
                }
            }
            const std::string what = std::string(scene.name) + " under " + std::string(name(kind));
            CAPTURE(what);
            CHECK(counted == 0);
        }
    }
}
