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
    std::vector<std::string> settings;  ///< for carom only: statements that replace the level's
};

enum class SceneSort : std::uint8_t { gas, pile, galton };

struct BenchScene {
    std::string name;
    std::string level;                  ///< a file in benchmarks/scenes
    std::vector<std::string> settings;  ///< statements that replace the level's
    SceneSort sort;
    RunPlan plan;
    std::vector<Contestant> contestants;
    /// Time of Box2D 3 (native, AVX2) divided by Chipmunk's, in this scene; measured once.
    double box2d3_by_chipmunk;
};

/// The statements that one run replaces in addition; none in the first run. Chance decides how deep
/// a pile's deepest pair lies, and whether a ball keeps rolling under an arch. So each run of a
/// pile falls from a lattice that differs by some ten-thousandths of a ball, the same for all
/// engines.
std::vector<std::string> arrangement(const BenchScene& scene, int run);

/// All scenes. `quick`: shorter runs, and no large scenes.
std::vector<BenchScene> bench_scenes(bool quick);

inline constexpr std::string_view chipmunk = "Chipmunk";
inline constexpr std::string_view box2d3_wasm = "Box2D 3 WASM";

}  // namespace carom::bench
