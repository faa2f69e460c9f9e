#pragma once

#include <optional>
#include <string_view>

#include "carom/controllers/confirmation.h"
#include "carom/controllers/free_controller.h"
#include "carom/controllers/pinball_feedback.h"
#include "carom/controllers/pinball_input.h"
#include "game/ai/demo_player.h"

/// Pinball: buttons held with keys or the mouse, the demo, high scores.
///
/// Attract mode: where nobody touches a key for a while before the first launch or after the end of
/// a game, the demo plays. Any key ends it, and the table stands as at the start.
namespace carom {

class PinballController : public FreeController {
  public:
    PlayKind kind() const override { return PlayKind::pinball; }
    bool take(PlayContext& play, const InputEvent& event) override;
    void perform(PlayContext& play, const Action& action) override;
    void pass(PlayContext& play, double seconds) override;
    void before_tick(PlayContext& play) override;
    void after_ticks(PlayContext& play, double seconds) override;
    void cut_panel(const PlayContext& play, CellArea& area) override;
    Camera fit(const PlayContext& play, const CellArea& area, double aspect) override;
    void look(PlayContext& play) override;
    void annotate(const PlayContext& play, Annotations& annotations) const override;
    void draw_panel(const PlayContext& play, Canvas& canvas) const override;
    void add_status(const PlayContext& play, HudInfo& info) const override;
    void add_hints(const PlayContext& play, std::vector<KeyHelp>& hints) const override;
    bool has_all_hints() const override { return feedback_.scores().initials().has_value(); }
    void set_high_scores(HighScores scores) override;
    bool drags_anything() const override { return false; }
    void continue_from(PlayContext& play, const Controller& before) override;

    /// Starts the demo, or hands control back to the player.
    void demonstrate(PlayContext& play, bool does);
    bool is_demonstrating() const { return demo_.has_value(); }
    void next_flipper_mode(PlayContext& play);
    /// A score for which the player has entered initials; returned once.
    PinballScores& scores() { return feedback_.scores(); }
    const PinballScores& scores() const { return feedback_.scores(); }

  private:
    bool take_mouse(PlayContext& play, const InputEvent& event);
    void learn_keys(PlayContext& play);
    void end_demo(PlayContext& play);
    bool asks_first(PlayContext& play, const Action& action);
    void attract(PlayContext& play, double seconds);
    void end_attract(PlayContext& play);
    void press_key(PlayContext& play, Button button, const InputEvent& event);

    PinballInput input_;
    std::optional<DemoPlayer> demo_;
    PinballFeedback feedback_;
    double idle_ = 0.0;  ///< s since the last key while the table waits for a player
    bool attracts_ = false;
    Confirmation confirmation_;
};

/// Whether a game of pinball has begun, by its first launch, and is not over. It is kept when the
/// player leaves, and does not end by one key alone.
bool is_in_pinball_game(const Session& session);

}  // namespace carom
