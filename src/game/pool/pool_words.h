#pragma once

#include <array>
#include <string>
#include <string_view>

#include "game/pool/pool.h"
#include "level/scene/scene.h"

/// Describes a game of pool in words, for status lines and reports.
namespace carom {

using PlayerNames = std::array<std::string, 2>;

/// "top left", "bottom middle": as seen on the screen. Pre: a pocket of the scene.
std::string pocket_name(const Scene& scene, int pocket);

std::string_view foul_text(PoolFoul foul);  ///< empty for none
/// What a choice does. `rules`: while it is due.
std::string_view choice_text(const PoolState& rules, PoolChoice choice);

/// "the 3 into the top left"; "the black"; "safety"; empty if nothing is called. Pre: the scene is
/// a game of pool, or nothing is called.
std::string call_text(const Scene& scene, const PoolCall& call);

/// Whose turn it is, and the task: "1:0 player 1, solids, 5 left: ball in hand"; with the points of
/// the frame in brackets: "1:0 (34:21) player 1, on a red, 67 left: to shoot".
std::string turn_text(const Scene& scene, const PoolPlay& play, const PlayerNames& names);

/// The time left for a shot, rounded up: "23 s".
std::string clock_text(double seconds);

/// The outcome of the last shot: "foul: the cue ball fell. player 2: ball in hand". Empty before
/// the first shot of a frame, and while balls roll.
std::string outcome_text(const PoolPlay& play, const PlayerNames& names);

}  // namespace carom
