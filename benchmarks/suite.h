#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene_list.h"

/// What is measured: the scenes, and the engines in each.
namespace carom::bench {

struct Contestant {
    std::string name;                   ///< in tables: "carom discrete", "Chipmunk"
    std::string program;                ///< bench_NAME beside the benchmark, or NAME.mjs
    std::vector<std::string> settings;  ///< carom's alone: statements that replace the level's
};

enum class SceneSort : std::uint8_t { gas, pile, galton };

struct BenchScene {
    std::string name;
    std::string level;                  ///< a file in benchmarks/scenes
    std::vector<std::string> settings;  ///< statements that replace the level's
    SceneSort sort;
    RunPlan plan;
    std::vector<Contestant> contestants;
    /// What Box2D 3 (native, AVX2) took for the same, by what Chipmunk took: measured once.
    double box2d3_by_chipmunk;
};

/// What a run replaces beside, the first run nothing. How deep a pile's deepest pair lies and
/// whether a ball goes on rolling under an arch is chance: each run of a pile falls from a lattice
/// that differs by some ten-thousandths of a ball, the same for all engines.
std::vector<std::string> arrangement(const BenchScene& scene, int run);

/// All scenes; `quick`: shorter runs, and none of the large scenes.
std::vector<BenchScene> bench_scenes(bool quick);

inline constexpr std::string_view chipmunk = "Chipmunk";
inline constexpr std::string_view box2d3_wasm = "Box2D 3 WASM";

}  // namespace carom::bench
