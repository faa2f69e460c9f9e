#include "suite.h"

#include <fmt/format.h>

#include <algorithm>

#include "physics/solver.h"

namespace carom::bench {
namespace {

// Keeps only solvers that this carom has. Other engines would call `substep` with four updates of
// one step each four substeps.
std::vector<Contestant> carom_solvers(const std::vector<SolverKind>& kinds) {
    std::vector<Contestant> contestants;
    for (const SolverKind kind : kinds) {
        if (std::ranges::find(solvers_available(), kind) == solvers_available().end()) continue;
        const std::string solver(name(kind));
        const std::string keys = kind == SolverKind::substep ? " updates=4 steps=1" : "";
        contestants.push_back({.name = "carom " + solver,
                               .program = "bench_carom",
                               .settings = {"solver " + solver + keys}});
    }
    return contestants;
}

std::vector<Contestant> with_peers(std::vector<Contestant> contestants, bool with_matter) {
    contestants.push_back({.name = std::string(chipmunk), .program = "bench_chipmunk"});
    contestants.push_back({.name = "Box2D 2.4", .program = "bench_box2d"});
    contestants.push_back({.name = std::string(box2d3_wasm), .program = "engine_box2d3.mjs"});
    contestants.push_back({.name = "Rapier WASM", .program = "engine_rapier.mjs"});
    contestants.push_back({.name = "Rapier WASM SIMD", .program = "engine_rapier_simd.mjs"});
    if (with_matter) contestants.push_back({.name = "matter.js", .program = "engine_matter.mjs"});
    return contestants;
}

RunPlan run(std::int64_t ticks, std::int64_t measured_from, std::int64_t sample_every) {
    return {.ticks = ticks, .measured_from = measured_from, .sample_every = sample_every};
}

}  // namespace

std::vector<BenchScene> bench_scenes(bool quick) {
    using enum SolverKind;
    const auto gas = carom_solvers({discrete, substep, swept, contact, event});
    const auto pile = carom_solvers({contact, substep});
    const auto galton = carom_solvers({contact, substep});
    const RunPlan gas_plan = run(quick ? 120 : 600, 0, 6);
    const RunPlan pile_plan = quick ? run(600, 400, 20) : run(1800, 1200, 20);
    RunPlan galton_plan = run(quick ? 1500 : 3000, 0, 20);
    galton_plan.landed = -14.0;

    std::vector<BenchScene> scenes{{.name = "gas 1,000",
                                    .level = "gas.level",
                                    .sort = SceneSort::gas,
                                    .plan = gas_plan,
                                    .contestants = with_peers(gas, true),
                                    .box2d3_by_chipmunk = 2.6},
                                   {.name = "pile 2,000, no friction",
                                    .level = "pile.level",
                                    .sort = SceneSort::pile,
                                    .plan = pile_plan,
                                    .contestants = with_peers(pile, !quick),
                                    .box2d3_by_chipmunk = 0.31},
                                   {.name = "pile 2,000, friction",
                                    .level = "pile-friction.level",
                                    .sort = SceneSort::pile,
                                    .plan = pile_plan,
                                    .contestants = with_peers(pile, !quick),
                                    .box2d3_by_chipmunk = 0.31},
                                   {.name = quick ? "galton 500" : "galton 5,000",
                                    .level = "galton.level",
                                    .settings = {quick ? "let n=500" : "let n=5000"},
                                    .sort = SceneSort::galton,
                                    .plan = galton_plan,
                                    .contestants = with_peers(galton, false),
                                    .box2d3_by_chipmunk = 0.68}};
    if (quick) return scenes;
    const std::vector<std::string> large_pile{"let columns=80 rows=125 width=100 height=150"};
    scenes.push_back({.name = "gas 10,000",
                      .level = "gas.level",
                      .settings = {"let n=10000"},
                      .sort = SceneSort::gas,
                      .plan = gas_plan,
                      .contestants = with_peers(gas, false),
                      .box2d3_by_chipmunk = 2.4});
    for (const bool has_friction : {false, true}) {
        scenes.push_back(
            {.name = has_friction ? "pile 10,000, friction" : "pile 10,000, no friction",
             .level = has_friction ? "pile-friction.level" : "pile.level",
             .settings = large_pile,
             .sort = SceneSort::pile,
             .plan = pile_plan,
             .contestants = with_peers(pile, false),
             .box2d3_by_chipmunk = 0.25});
    }
    return scenes;
}

std::vector<std::string> arrangement(const BenchScene& scene, int run) {
    if (scene.sort != SceneSort::pile || run == 0) return {};
    // 0.04, 0.0404, 0.0396, 0.0408, ...
    const double away = 0.0004 * ((run + 1) / 2);
    return {fmt::format("let jitter={}", run % 2 == 1 ? 0.04 + away : 0.04 - away)};
}

}  // namespace carom::bench
