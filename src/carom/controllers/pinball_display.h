#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "carom/controllers/pinball_messages.h"
#include "carom/controllers/pinball_scores.h"
#include "game/session/session.h"
#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/canvas/table_camera.h"
#include "terminal/draw/table_annotations.h"
#include "terminal/panels/score_panel.h"

/// The picture of a pinball table: the part around the ball, the lights, and the score panel.
namespace carom {

class PinballDisplay {
  public:
    /// Glides after the lowest ball. `seconds`: of wall-clock time.
    void follow(const Session& session, double seconds);
    /// Takes the room for the score panel from the right of `area`, and in a wide window that for
    /// the rules card from its left. `table`: what the camera shows.
    void cut_panel(const Session& session, CellArea& area, const Box& table);
    /// Takes up what the table says. Returns whether messages().text() has changed.
    bool listen(const Session& session) { return messages_.follow(session); }
    const PinballMessages& messages() const { return messages_; }
    bool has_panel() const { return panel_.columns > 0; }
    /// `whole`: shows the whole table, however small the ball gets.
    Camera look(const Session& session, const Box& table, const CellArea& area, double aspect,
                bool whole);
    TableAnnotations annotations(const Session& session) const;
    void draw_panel(Canvas& canvas, const Session& session, const PinballScores& scores,
                    bool is_demonstrating, const Look& look) const;

  private:
    void count_ball(const PinballState& state);

    TableCamera camera_;
    CellArea panel_;
    CellArea card_;

    PinballMessages messages_;  ///< told in the panel, since nothing may hide a ball in play

    /// What a ball of this game scored, of one player.
    struct BallScore {
        std::uint32_t ball = 0;
        std::int64_t score = 0;
    };
    std::vector<BallScore> ball_scores_;  ///< of those that were seen from their beginning
    std::uint32_t ball_ = 0;              ///< in play, when last looked at; after a game one more
    std::int64_t score_ = 0;              ///< when last looked at
    std::optional<std::int64_t> began_;   ///< the score with which it began, if that is known
};

}  // namespace carom
