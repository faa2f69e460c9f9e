#pragma once

#include <span>
#include <string_view>

#include "game/ai/play_style.h"
#include "game/ai/shot_noise.h"

/// Whom a person can play against at pool: carom at one of its levels of skill, and the people of
/// the ladder, who have names, hands and styles of their own.
namespace carom {

struct AiPlayer {
    std::string_view name;
    ShotNoise noise;
    PlayStyle style;
    std::string_view manner;  ///< "a careful beginner"
};

/// A match on the ladder, which is climbed from the first rung to the last.
struct LadderRung {
    std::string_view level;  ///< the name of a level that ships
    std::string_view game;   ///< "9-ball to 3"
    std::string_view rules;  ///< the level's `game` statement for this match
    int opponent = 0;        ///< number of an AI player
};

/// AI players are numbered: 1 to most_skill are carom by skill (planner.h), then comes the ladder.
inline constexpr int most_opponent = 11;
/// Pre: 1 <= number <= most_opponent.
const AiPlayer& ai_player(int number);
std::span<const LadderRung> ladder();
/// Whether this AI player is one of the ladder's.
bool is_of_ladder(int number);

}  // namespace carom
