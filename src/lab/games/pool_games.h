#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "level/scene/scene.h"
#include "physics/solver.h"

/// Plays carom against carom at a pool table, without a screen: the winner and the length of each
/// frame, and whether every frame ends.
namespace carom {

/// One frame.
struct PoolFrame {
    std::optional<int> winner;  ///< player 0 or 1; none: the frame was not finished
    std::uint32_t shots = 0;
    std::array<std::uint32_t, 2> fouls{};  ///< of each player
    int breaker = 0;
    bool is_break_and_run = false;  ///< the breaker won before the opponent had a shot
    double seconds = 0.0;           ///< simulated, while balls were moving
    /// A command that the rules or the world refused, which is a fault: a sentence.
    std::optional<std::string> refused;
};

/// A frame is abandoned after this many shots and choices, far more than a normal frame takes.
inline constexpr std::uint32_t most_decisions = 2000;

/// Plays frame number `number` between two AI players of these skills (game/ai/planner.h), who
/// break in turn. The result depends on the arguments alone: each number has its own random draws.
/// Pre: the scene is a game of pool.
PoolFrame play_pool_frame(const Scene& scene, const SolverSettings& solver,
                          const std::array<int, 2>& skill, std::uint32_t number);

/// The results of a number of frames.
struct PoolMatch {
    std::array<int, 2> skill{};
    std::vector<PoolFrame> frames;
};

std::uint32_t frames_won(const PoolMatch& match, int player);
std::uint32_t frames_unfinished(const PoolMatch& match);
/// Frames that the player who broke won.
std::uint32_t frames_of_breakers(const PoolMatch& match);
/// Frames that this player broke, and won before the opponent had a shot.
std::uint32_t breaks_and_runs(const PoolMatch& match, int player);

/// The 95 % confidence interval of a share, by Wilson's formula. 0..1 without frames.
struct ShareRange {
    double low = 0.0;
    double high = 1.0;
};
ShareRange likely_share(std::uint32_t won, std::uint32_t frames);

/// The heading of a table in Markdown, and its row for one match.
std::string pool_match_head();
std::string pool_match_row(std::string_view game, const PoolMatch& match);

}  // namespace carom
