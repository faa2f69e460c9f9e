#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/commands/command.h"
#include "geometry/vec2.h"
#include "level/scene/scene.h"

/// The shot of the day: a pot and a place for the cue ball, drawn from the date.
namespace carom {

struct DailyShot {
    Vec2 cue;                 ///< places, length; whole millimetres
    Vec2 object;              ///< the ball to pocket
    Vec2 ring;                ///< where the cue ball has to stop
    command::Strike example;  ///< a stroke that does it
};

/// The shot for a date, 20260131. It depends on the date and the level alone, and it can be made:
/// it is found by shooting, and the ring lies where the cue ball stops. None: no shot is found, on
/// a table that is not one of pool. Cost: some dozen simulated shots.
///
/// Pre: the level has a cue, and a ball named `object`.
std::optional<DailyShot> daily_shot(const Scene& scene, int date);

/// The amendments of the level that set the shot up: "let cx=-500", ...
std::vector<std::string> amendments_of(const DailyShot& shot, int date);

}  // namespace carom
