#pragma once

#include <functional>
#include <string>
#include <vector>

#include "runs.h"

/// Measurements of carom alone: the gas, from few balls to many.
namespace carom::bench {

struct OwnCost {
    std::string solver;
    std::size_t balls = 0;
    double ns_a_ball_tick = 0.0;
    double bytes_a_ball = 0.0;  ///< heap of world and solver after the run
};

struct OwnEvents {
    std::size_t balls = 0;
    double rate = 60.0;                ///< ticks a simulated second
    double collisions_a_second = 0.0;  ///< of processor time
};

struct OwnFigures {
    std::vector<OwnCost> costs;  ///< by solver, then by balls
    std::vector<OwnEvents> events;
};

/// Medians of `rounds` runs by turns. `quick`: up to 10,000 balls, else up to 1,000,000.
OwnFigures measure_own(const Places& places, bool quick, int rounds,
                       const std::function<void(const std::string&)>& say);

}  // namespace carom::bench
