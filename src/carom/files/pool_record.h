#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "game/ai/opponents.h"

/// What a person has done in matches of pool against carom, kept in one small text file in the
/// user's data folder: a first line with the format, then one line a figure:
///
///     carom pool record 1
///     shots 120
///     seconds 1834
///     opponent 2 3 1
///     match nell 1 0
///
/// the last ones meaning 3 frames won against carom at skill 2, and 1 lost; and a match won against
/// Nell of the ladder. A file in another format is never overwritten.
namespace carom {

struct PoolRecord {
    struct Results {
        std::uint64_t won = 0;
        std::uint64_t lost = 0;

        friend bool operator==(const Results&, const Results&) = default;
    };
    std::uint64_t shots = 0;
    std::uint64_t pots = 0;      ///< balls, on shots after which the turn went on
    std::uint64_t attempts = 0;  ///< shots at a ball: neither breaks nor called safeties
    std::uint64_t made = 0;      ///< of these, with a ball down and the turn going on
    std::uint64_t safeties = 0;  ///< called, without a foul
    std::uint64_t fouls = 0;
    std::uint64_t turns = 0;            ///< at the table
    std::uint64_t best_run = 0;         ///< balls in one turn at the table
    std::uint64_t breaks_and_runs = 0;  ///< frames won from the break, in one turn
    double seconds = 0.0;               ///< from one's turn to the shot, in all
    /// Frames, and matches with a length, by AI player (game/ai/opponents.h), from number 1.
    std::array<Results, most_opponent> frames{};
    std::array<Results, most_opponent> matches{};

    friend bool operator==(const PoolRecord&, const PoolRecord&) = default;
};

/// How many rungs of the ladder are climbed: a rung is, once a match on it is won.
std::size_t rungs_climbed(const PoolRecord& record);

/// Adds what was done since: sums, and the better of the best runs.
void add(PoolRecord& record, const PoolRecord& more);

struct PoolRecordText {
    PoolRecord record;
    std::optional<std::string> problem;  ///< set if the file cannot be used: a sentence
};
/// `file` is for the error message.
PoolRecordText read_pool_record(std::string_view text, std::string_view file);
std::string text_of(const PoolRecord& record);

/// Reads the user's file; empty for a user without one.
PoolRecordText load_pool_record();
/// Rereads the user's file, adds, and returns the sum. The file is replaced at once or not at all,
/// under a lock, so that two games that end together are both kept.
PoolRecordText keep_pool_record(const PoolRecord& more);

}  // namespace carom
