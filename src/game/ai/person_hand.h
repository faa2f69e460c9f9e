#pragma once

#include <cstdint>

#include "game/commands/command.h"

/// The hand of a person who plays a match: what becomes of an intended shot.
namespace carom {

/// How a player struck: with the mouse, or with the meter.
struct Stroke {
    double speed = 0.0;  ///< of the cue, length/s, > 0
    double miss = 0.0;   ///< -1..1: how far off the line, and to which side (left is positive)
};

/// Levels of the hand, as of carom's skill (ai/planner.h): 1 errs most.
inline constexpr int least_hand = 1;
inline constexpr int most_hand = 4;

/// The greatest error of the direction that a stroke itself causes, degrees, at a miss of 1.
/// Pre: least_hand <= level <= most_hand.
double most_miss(int level);

/// What became of the intended strike: the stroke's speed, its miss, and the error of a hand of
/// this level, half of that of carom's skill of the same level. The error is drawn from the seed
/// and the number of the shot, so the same stroke gives the same shot again. At most `most` fast.
/// Pre: least_hand <= level <= most_hand.
command::Strike struck(const command::Strike& intended, const Stroke& stroke, int level,
                       double most, std::uint64_t seed, std::uint64_t shot);

/// What becomes of a strike where the level's cue scatters (Cue::scatter): its direction errs by
/// this standard deviation, degrees, drawn from the seed and the number of the shot.
command::Strike scattered(const command::Strike& intended, double scatter, double most,
                          std::uint64_t seed, std::uint64_t shot);

}  // namespace carom
