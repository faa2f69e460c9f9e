#pragma once

#include <string>
#include <vector>

#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"

/// What stands beside a pinball table: the score in large characters, and how the game goes.
namespace carom {

struct ScoreLine {
    std::string rank;
    std::string name;
    std::string score;
    bool is_new = false;
};

struct ScorePanel {
    std::string title;
    std::string score;                   ///< digits and commas
    std::string message;                 ///< in a box; may be empty
    std::vector<std::string> lines;      ///< the ball, the bonus ...
    std::string call;                    ///< to the player, as "SHOOT AGAIN"; may be empty
    std::vector<ScoreLine> high_scores;  ///< the best first
};

/// Columns that it wants.
inline constexpr int score_panel_columns = 34;

/// As much of it as fits. Digits are of half blocks or of number signs; a score too long for them
/// is written small.
void draw_score_panel(Canvas& canvas, const CellArea& area, const ScorePanel& panel,
                      const Look& look);

}  // namespace carom
