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
    /// Looks at the game, at least once between two shots. `opponent`: the number of an AI player;
    /// 0: there is none, and nothing counts.
    void look(const PoolPlay& pool, int opponent);
    /// Lets the person's seconds pass. Pre: it is the person's turn to shoot or choose.
    void pass(double seconds) { waited_ += seconds; }

    /// The person leaves the frame, and a match with a length, for a new one, which counts as
    /// lost. Pre: the match is not over.
    void give_up(const PoolPlay& pool, int opponent);

    /// What has been counted since the last call.
    PoolRecord take() { return std::exchange(since_, {}); }
    const PoolRecord& since() const { return since_; }
    /// Whether a frame has ended since the last call.
    bool has_ended() { return std::exchange(has_ended_, false); }

  private:
    void count_shot(const PoolPlay& pool);
    void count_frame(const PoolPlay& pool, std::size_t opponent);

    PoolRecord since_;
    std::optional<std::uint32_t> shots_;  ///< seen so far
    bool was_shooting_ = false;
    bool was_over_ = false;
    bool is_safety_ = false;  ///< the call of the shot in progress
    bool is_break_ = false;   ///< the shot in progress, or the next one
    std::uint64_t run_ = 0;   ///< balls in this turn at the table
    std::uint64_t shots_in_turn_ = 0;
    bool broke_ = false;   ///< this turn began with a break
    double waited_ = 0.0;  ///< s in this turn
    bool has_ended_ = false;
};

}  // namespace carom
