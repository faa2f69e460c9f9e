#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "carom/files/level_files.h"
#include "carom/files/level_source.h"
#include "carom/files/pool_record.h"

/// The menu's group of challenges at pool: the shot of the day, the ladder of opponents, a match
/// for two people, and the player's record.
namespace carom {

inline constexpr std::string_view challenge_group = "Challenge";
/// The level of the shot of the day, which the menu sets up by the date.
inline constexpr std::string_view daily_level = "shot-of-the-day";

struct Challenge {
    enum class Kind : std::uint8_t { daily, match, record };
    Kind kind = Kind::match;
    std::string name;   ///< of the menu's item, to be selected again
    std::string level;  ///< path; of a record, that of the picture
    std::string title;
    std::string line;
    std::string goal;
    std::string badge;
    std::vector<std::string> amendments{};  ///< of the level, as by --set
    int opponent = 0;                       ///< number of an AI player; 0: two people
    int date = 0;                           ///< of the shot of the day: 20260131
    std::string obstacle{};                 ///< why it cannot be played yet; empty: it can
};

/// The challenges whose levels ship, in the menu's order. `date`: today.
std::vector<Challenge> challenges(std::span<const LevelEntry> shipped, const PoolRecord& record,
                                  int date);

/// The level of a challenge, with its amendments.
LevelSource source_of(const PlayOptions& options, const Challenge& challenge);

/// The item of the rung that the player climbs next; empty: all are climbed.
std::string next_challenge(const PoolRecord& record);

/// "Nell is beaten. Next on the ladder: Bo, 9-ball to 2." Pre: rungs_climbed(record) > 0.
std::string climb_text(const PoolRecord& record);

/// The name under which the stars of the shot of that day are kept.
std::string daily_name(int date);
/// Today by the local calendar: 20260131.
int today();

}  // namespace carom
