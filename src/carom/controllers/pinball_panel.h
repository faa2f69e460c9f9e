#pragma once

#include <cstdint>
#include <string>

#include "carom/controllers/pinball_scores.h"
#include "game/session/session.h"
#include "terminal/panels/score_panel.h"

namespace carom {

/// What the score panel of a pinball table says: the scores, the state of the ball and of the task,
/// lights that go out, high scores. `is_demonstrating`: carom plays.
/// Pre: the session is a game of pinball.
ScorePanel score_panel(const Session& session, const PinballScores& scores, bool is_demonstrating);

}  // namespace carom
