#pragma once

#include <optional>

#include "carom/context/controller.h"
#include "carom/controllers/pinball_feedback.h"
#include "carom/pool/pool_players.h"
#include "carom/pool/pool_status.h"

/// Watching a recording: keys control only time and view, and the mouse drags the view. Pool and
/// pinball show score and turn as they do in play.
namespace carom {

class WatchController : public Controller {
  public:
    explicit WatchController(const Session& session);

    PlayKind kind() const override { return PlayKind::watching; }
    void perform(PlayContext& play, const Action& action) override;
    void press(PlayContext& play, const InputEvent& event) override;
    void pass(PlayContext& play, double seconds) override;
    void after_ticks(PlayContext& play, double seconds) override;
    void cut_panel(const PlayContext& play, CellArea& area) override;
    Camera fit(const PlayContext& play, const CellArea& area, double aspect) override;
    void look(PlayContext& play) override;
    void annotate(const PlayContext& play, Annotations& annotations) const override;
    void draw_panel(const PlayContext& play, Canvas& canvas) const override;
    void add_status(const PlayContext& play, HudInfo& info) const override;
    void set_high_scores(HighScores scores) override;
    /// Names the players of a game of pool: Replay::opponent.
    void set_opponent(int number) { names_ = names_against(number); }

  private:
    ShotAnnouncer announcer_;
    PlayerNames names_ = names_against(0);
    std::optional<PinballFeedback> pinball_;  ///< none: not a pinball table
    CellArea pool_panel_;                     ///< empty away from pool tables
};

}  // namespace carom
