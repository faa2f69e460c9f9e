#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "game/commands/command.h"
#include "game/pinball/pinball_state.h"
#include "level/scene/scene.h"
#include "physics/solver.h"

/// Plays many games of pinball without a screen: the scores that a table gives, how long a ball
/// lasts and where it drains, and whether one is ever stuck or lost.
namespace carom {

/// The buttons that a player presses and releases before the next tick.
using PinballPlayer =
    std::function<std::vector<command::Press>(const Scene&, const World&, const PinballState&)>;

/// Where a ball leaves play: beside the lower pair of flippers, or between them.
enum class DrainPlace : std::uint8_t { left_outlane, middle, right_outlane };

struct PinballGames {
    std::vector<std::int64_t> scores;  ///< of each finished game
    /// s from the first launch to the end of the ball, for each ball of a game; what the ball
    /// saver or multiball returned belongs to it.
    std::vector<double> ball_times;
    std::array<std::uint64_t, 3> drains{};  ///< by DrainPlace, balls that were saved included
    std::uint64_t saved = 0;                ///< of the drained balls
    std::uint64_t searches = 0;             ///< kicks by the ball search
    std::uint64_t lost = 0;                 ///< balls that no kick freed, or that left the table
    std::uint64_t outside = 0;  ///< ticks after which a ball was outside the table's bounds
    double seconds = 0.0;       ///< simulated
    /// Shots from a cradle, if the player counts them, and how many hit what they were meant for.
    std::uint64_t shots_tried = 0;
    std::uint64_t shots_made = 0;
};

/// Plays games until `balls` have ended, or an hour without a ball's end or `seconds` in all have
/// been simulated. `keep_going`, if any, is asked after each ball. Pre: the scene is a game of
/// pinball.
PinballGames play_pinball(const Scene& scene, const SolverSettings& solver, std::uint64_t balls,
                          const PinballPlayer& player, const std::function<bool()>& keep_going = {},
                          double seconds = std::numeric_limits<double>::infinity());

double mean_ball_time(const PinballGames& games);
/// The share of balls that last less than this, and of drains that are through an outlane; 0..1.
double share_under(const PinballGames& games, double seconds);
double outlane_share(const PinballGames& games);

/// For people: totals, and two histograms in characters.
std::string pinball_games_text(const PinballGames& games);

}  // namespace carom
