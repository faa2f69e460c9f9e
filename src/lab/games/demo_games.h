#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "level/scene/scene.h"
#include "physics/solver.h"

/// Runs many demo games of pinball without a screen: the scores that a table gives, how long a ball
/// lasts, and whether one is ever stuck or lost.
namespace carom {

struct DemoGames {
    std::vector<std::int64_t> scores;  ///< of each finished game
    std::vector<double> ball_times;    ///< s from serve to drain, for each ball that drained
    std::uint64_t searches = 0;        ///< kicks by the ball search
    std::uint64_t lost = 0;            ///< balls that no kick freed, or that left the table
    std::uint64_t outside = 0;         ///< ticks after which a ball was outside the table's bounds
    double seconds = 0.0;              ///< simulated
};

/// Plays games until `balls` have drained, or an hour per ball has passed. `keep_going`, if any, is
/// asked after each ball. Pre: the scene is a game of pinball.
DemoGames play_demo_games(const Scene& scene, const SolverSettings& solver, std::uint64_t balls,
                          const std::function<bool()>& keep_going = {});

/// For people: totals, and two histograms in characters.
std::string demo_games_text(const DemoGames& games);

}  // namespace carom
