#pragma once

#include <string>

#include "carom/context/play_context.h"
#include "carom/controllers/pinball_bell.h"
#include "carom/controllers/pinball_display.h"
#include "carom/controllers/pinball_scores.h"

/// What the player sees and hears of a pinball table, whether it is played or watched.
namespace carom {

class PinballFeedback {
  public:
    static bool is_at(const Session& session);

    PinballScores& scores() { return scores_; }
    const PinballScores& scores() const { return scores_; }

    void pass(const PlayContext& play, double seconds) { display_.follow(play.session, seconds); }
    /// Rings the bell, asks for initials, and passes on what the table says. Beside the table there
    /// is room for that, so that the hints stay in sight.
    void after_ticks(PlayContext& play, double seconds, bool is_demonstrating);

    void cut_panel(CellArea& area) { display_.cut_panel(area); }
    Camera fit(const PlayContext& play, const CellArea& area, double aspect);
    void mark(const PlayContext& play, Marks& marks) const;
    void draw_panel(const PlayContext& play, Canvas& canvas, bool is_demonstrating) const;
    /// The score, where the window has no room for the panel.
    void add_score(const PlayContext& play, HudInfo& info) const;

  private:
    PinballDisplay display_;
    PinballBell bell_;
    PinballScores scores_;
    std::string heard_;  ///< what the table said last
};

}  // namespace carom
