#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bits/level_writer.h"
#include "bits/scene_random.h"

/// Writes recordings of players who grab, throw, place, add and remove balls and edges, press
/// buttons, and change gravity and solver, all at random: see src/game/replay/replay_text.h.
namespace carom::bits {

struct TimedLine {
    int tick = 0;
    std::string command;
};

/// Commands for a level, in order of their ticks. The game may refuse some.
std::vector<TimedLine> write_commands(Random& random, const Level& level);

/// The hash of a level's text, as a recording has it.
std::uint64_t level_hash(std::string_view text);

/// A whole recording. It has a wrong fingerprint at the last tick only, so that verifying it prints
/// the right one.
std::string write_recording(const Level& level, const std::string& solver,
                            const std::vector<TimedLine>& commands);

/// Any solver with its settings, in the syntax of recordings.
std::string write_solver(Random& random, bool has_cloth);

}  // namespace carom::bits
