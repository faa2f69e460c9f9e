#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "level/scene/scene.h"
#include "physics/solver.h"

/// carom at its own tables for a long time, without a screen: what scores a table gives, how long a
/// ball lasts, and whether one is ever stuck or lost.
namespace carom {

struct DemoGames {
    std::vector<std::int64_t> scores;  ///< of each finished game
    std::vector<double> ball_times;    ///< s from serve to drain, for each ball that drained
    std::uint64_t searches = 0;        ///< kicks that the ball search gave to stuck balls
    std::uint64_t lost = 0;            ///< balls that no kick freed, or that left the table
    std::uint64_t outside = 0;         ///< ticks after which a ball was out of the table's bounds
    double seconds = 0.0;              ///< simulated
};

/// Plays one game after another until `balls` have drained, or for an hour a ball at most.
/// `keep_going`, if any, is asked after each ball.
/// Pre: the scene is a game of pinball.
DemoGames play_demo_games(const Scene& scene, const SolverSettings& solver, std::uint64_t balls,
                          const std::function<bool()>& keep_going = {});

/// For people: sums, and two histograms in characters.
std::string demo_games_text(const DemoGames& games);

}  // namespace carom
