#pragma once

#include <cstdint>
#include <vector>

#include "level/ir/context.h"
#include "level/scene/rules.h"

/// Rules that are no error, but never do what they say: conditions that cannot hold, tasks that are
/// never shown, variables that nothing sets, two ends of a game at once.
namespace carom {

/// What the table allows, by the indices of a RuleBook before the world exists.
struct RuleFacts {
    /// How many balls there can be of each of RuleBook::balls.
    std::vector<std::int64_t> balls;
    /// Whether each of RuleBook::places takes all balls that reach it, so that none ever lies
    /// there.
    std::vector<bool> takes_balls;
    /// All players strike one and the same ball.
    bool has_one_cue_ball = false;
};

/// Reports them as warnings. Pre: `book` has a rule, a task and a goal for each of those in the
/// context's level, in their order.
void warn_of_futile_rules(const RuleBook& book, const RuleFacts& facts, Context& context);

}  // namespace carom
