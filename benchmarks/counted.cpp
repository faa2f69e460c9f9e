#include "counted.h"

#include <fmt/format.h>

#include "heap.h"
#include "level/load.h"

namespace carom::bench {
namespace {

struct Loaded {
    World world;
    SolverSettings settings;
};

std::optional<Loaded> load(const CountedScene& scene, SolverKind solver) {
    LoadOptions options;
    options.overrides = scene.overrides;
    const char* keys = solver == SolverKind::substep ? " updates=4 steps=1" : "";
    options.overrides.push_back(fmt::format("solver {}{}", name(solver), keys));
    const LoadResult result = load_level(scene.text, scene.name + ".level", options);
    if (!result.scene) return std::nullopt;
    return Loaded{.world = result.scene->world, .settings = *result.scene->solver};
}

}  // namespace

std::optional<Count> count_scene(InstructionCounter& counter, const CountedScene& scene,
                                 SolverKind kind) {
    const std::size_t before = heap_bytes();
    std::optional<Loaded> loaded = load(scene, kind);
    if (!loaded) return std::nullopt;
    World& world = loaded->world;
    Solver solver(loaded->settings);
    if (scene.prepare) scene.prepare(world);
    const auto tick = [&](int ticks) {
        for (int i = 0; i < ticks; ++i) {
            if (scene.before_tick) scene.before_tick(world);
            solver.tick(world);
        }
    };
    tick(scene.warm_ticks);
    std::size_t ball_ticks = 0;
    const std::uint64_t instructions = counter.count([&] {
        for (int i = 0; i < scene.ticks; ++i) {
            tick(1);
            ball_ticks += world.balls().size();
        }
    });
    const auto all = static_cast<double>(instructions);
    return Count{.instructions_a_tick = all / scene.ticks,
                 .instructions_a_ball_tick = all / static_cast<double>(ball_ticks),
                 .bytes_a_ball = static_cast<double>(heap_bytes() - before) /
                                 static_cast<double>(world.balls().size())};
}

}  // namespace carom::bench
