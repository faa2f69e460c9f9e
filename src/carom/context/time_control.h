#pragma once

#include "carom/context/play_context.h"

/// The player's control of time: pause, single ticks, search, rewind.
namespace carom {

void toggle_pause(PlayContext& play);
void step_forward(PlayContext& play);
void step_back(PlayContext& play);
void seek_collision(PlayContext& play);
void second_forward(PlayContext& play);
void second_back(PlayContext& play);
void slower(PlayContext& play);
void faster(PlayContext& play);
void normal_speed(PlayContext& play);
void restart(PlayContext& play);

/// Lets `seconds` of wall-clock time pass: computes ticks as long as `may_go_on` allows, and
/// reports the results. The game waits for its companion where that is behind.
void advance_time(PlayContext& play, double seconds, const MayGoOn& may_go_on);

}  // namespace carom
