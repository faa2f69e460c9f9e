#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "instruction_count.h"
#include "physics/solver.h"

/// The cost of a solver in a scene, counted in instructions instead of time.
namespace carom::bench {

struct CountedScene {
    std::string name;
    std::string text;                    ///< the level
    std::vector<std::string> overrides;  ///< statements that replace the level's
    int warm_ticks = 5;                  ///< before counting
    int ticks = 10;                      ///< counted
    /// Called with the world at its start, and before each tick.
    std::function<void(World&)> prepare;
    std::function<void(World&)> before_tick;
};

struct Count {
    double instructions_a_tick = 0.0;
    double instructions_a_ball_tick = 0.0;
    double bytes_a_ball = 0.0;  ///< heap of world and solver, at the end
};

/// None when the level does not load.
std::optional<Count> count_scene(InstructionCounter& counter, const CountedScene& scene,
                                 SolverKind solver);

}  // namespace carom::bench
