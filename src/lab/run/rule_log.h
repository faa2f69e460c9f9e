#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "game/session/game_state.h"

/// What the rules of a level did in a run, for the author of the level.
namespace carom {

/// Follows a game tick by tick.
class RuleLog {
  public:
    /// A line with the numbers and variables that have changed since the last call, and the message
    /// if it has; empty: nothing has. The first call notes the start, and says nothing.
    ///
    ///     tick 452, 3.767 s: hits 1, score1 6, "1 hit: 1 point"
    ///
    /// A variable of `player` has the player's number behind its name. Conditions are tested before
    /// the rules of their event act. If a rule's condition holds for only one of a variable's old
    /// and new values, the line shows the value that it tested:
    ///
    ///     tick 452, 3.767 s: hits 3; line 23 tested hits at 2
    ///
    /// Cost: all numbers of the game, by name, and all rules in a tick that changes a variable.
    std::string line(const Scene& scene, const World& world, const GameState& game);

  private:
    std::map<std::string, std::int64_t> numbers_;
    std::string message_;
    bool has_begun_ = false;
};

}  // namespace carom
