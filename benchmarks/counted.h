#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "instruction_count.h"
#include "physics/solver.h"

/// What a solver costs in a scene, without a clock.
namespace carom::bench {

struct CountedScene {
    std::string name;
    std::string text;                    ///< of the level
    std::vector<std::string> overrides;  ///< statements that take the place of the level's
    int warm_ticks = 5;                  ///< before it counts
    int ticks = 10;                      ///< that count
    /// What is done to the world at its start, and before each tick.
    std::function<void(World&)> prepare;
    std::function<void(World&)> before_tick;
};

struct Count {
    double instructions_a_tick = 0.0;
    double instructions_a_ball_tick = 0.0;
    double bytes_a_ball = 0.0;  ///< of the heap: world and solver, at the end
};

/// None when the level does not load.
std::optional<Count> count_scene(InstructionCounter& counter, const CountedScene& scene,
                                 SolverKind solver);

}  // namespace carom::bench
