#pragma once

#include <cstdint>

#include "carom/context/play_context.h"
#include "carom/controllers/pinball_bell.h"
#include "carom/controllers/pinball_display.h"
#include "carom/controllers/pinball_scores.h"

/// Picture, sound and messages of a pinball table, in play and in a watched recording.
namespace carom {

class PinballFeedback {
  public:
    static bool is_at(const Session& session);

    PinballScores& scores() { return scores_; }
    const PinballScores& scores() const { return scores_; }

    /// Whether the game has scored, and its score may enter the high scores.
    bool may_enter(const PlayContext& play) const;

    void pass(PlayContext& play, double seconds);
    /// Rings the bell, asks for initials, and shows the table's messages: in the score panel where
    /// there is one, so that the hints stay visible.
    void after_ticks(PlayContext& play, double seconds, bool is_demonstrating);

    void cut_panel(const PlayContext& play, CellArea& area) {
        display_.cut_panel(play.session, area, play.view.shown);
    }
    bool has_panel() const { return display_.has_panel(); }
    Camera fit(const PlayContext& play, const CellArea& area, double aspect);
    void annotate(const PlayContext& play, Annotations& annotations) const;
    void draw_panel(const PlayContext& play, Canvas& canvas, bool is_demonstrating) const;
    /// Shows the score in the status line, if the window has no room for the panel.
    void add_score(const PlayContext& play, HudInfo& info) const;

  private:
    void listen(PlayContext& play);
    void note_time(PlayContext& play);
    void leave_out(PlayContext& play, const char* why);

    PinballDisplay display_;
    PinballBell bell_;
    PinballScores scores_;
    std::uint64_t latest_ = 0;  ///< the latest tick of the session, when last looked at
};

}  // namespace carom
