#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "game/rules/rules.h"

/// The goal of a level (`goal`, LevelGoal): whether it is reached, how well, and in words.
namespace carom {

/// What a goal has cost so far, and whether it was reached. Plain state of a game.
struct GoalState {
    std::uint32_t shots = 0;
    std::uint64_t begun = 0;  ///< the tick in which the game began

    /// The first time that the conditions held.
    struct Done {
        std::uint32_t shots = 0;
        std::uint64_t tick = 0;
        int stars = 0;       ///< 0: not within the limits, to 3
        double spent = 0.0;  ///< of what the goal counts

        friend bool operator==(const Done&, const Done&) = default;
    };
    std::optional<Done> done;

    friend bool operator==(const GoalState&, const GoalState&) = default;
};

inline constexpr int most_stars = 3;

/// Three stars within the first limit, two within the second, one within the third, else none; a
/// goal without limits gives three. Of a goal that counts a value (LevelGoal::Counts::value), the
/// limits are the least.
int stars_within(const LevelGoal& goal, double spent);

/// Notes that the level's goal is reached, if it is. Pre: the tick is over.
void note_goal(const RuleBook& book, const RuleState& rules, const RuleHost& host, GoalState& goal);

/// "Clear the table. (1 of 4 shots; 2 for 3 stars)"; once it is reached "Done in 3 shots: 2 of 3
/// stars", or "No star with 2: it takes 3"; empty: the level has no goal.
std::string goal_text(const RuleBook& book, const GoalState& goal);

/// Adds the state to a fingerprint.
void add_to(Digest& digest, const GoalState& goal);

}  // namespace carom
