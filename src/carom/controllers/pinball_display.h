#pragma once

#include <cstdint>
#include <string>

#include "carom/controllers/pinball_scores.h"
#include "game/session/session.h"
#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/canvas/table_camera.h"
#include "terminal/draw/table_marks.h"
#include "terminal/panels/score_panel.h"

/// What a player sees of a pinball table: the part of it around the ball, its lights, and the score
/// beside it.
namespace carom {

class PinballDisplay {
  public:
    /// The picture glides after the lowest ball. `seconds`: of the player's time.
    void follow(const Session& session, double seconds);
    /// Takes the room for the score from the right of `area`, where there is enough.
    void cut_panel(CellArea& area);
    bool has_panel() const { return panel_.columns > 0; }
    /// `whole`: all of the table, however small the ball gets.
    Camera look(const Session& session, const CellArea& area, double aspect, bool whole);
    TableMarks marks(const Session& session) const;
    void draw_panel(Canvas& canvas, const Session& session, const PinballScores& scores,
                    bool is_demonstrating, const Look& look) const;

  private:
    TableCamera camera_;
    CellArea panel_;
};

/// 1234567 as 1,234,567.
std::string grouped(std::int64_t number);

}  // namespace carom
