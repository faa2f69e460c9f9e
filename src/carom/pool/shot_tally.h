#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "carom/files/pool_record.h"
#include "game/pool/pool.h"

namespace carom {

/// Counts shots, pots and fouls of the first player, a person, in a match against carom.
class ShotTally {
  public:
    /// Looks at the game, at least once between two shots. `opponent`: its skill, from 1; 0: there
    /// is none, and nothing counts.
    void look(const PoolPlay& pool, int opponent);
    /// Lets the person's seconds pass. Pre: it is the person's turn to shoot or choose.
    void pass(double seconds) { waited_ += seconds; }

    /// What has been counted since the last call.
    PoolRecord take() { return std::exchange(since_, {}); }
    const PoolRecord& since() const { return since_; }
    /// Whether a frame has ended since the last call.
    bool has_ended() { return std::exchange(has_ended_, false); }

  private:
    void count_shot(const PoolPlay& pool);

    PoolRecord since_;
    std::optional<std::uint32_t> shots_;  ///< seen so far
    bool was_shooting_ = false;
    bool was_over_ = false;
    bool is_safety_ = false;  ///< the call of the shot in progress
    std::uint64_t run_ = 0;   ///< balls in this turn at the table
    double waited_ = 0.0;     ///< s in this turn
    bool has_ended_ = false;
};

/// "120 shots, 60 balls, best run 5, 4 safeties, 9 s a shot; frames 3:1 0:2 0:0 0:0".
std::string text_for_player(const PoolRecord& record);

}  // namespace carom
