#pragma once

#include <optional>
#include <string>
#include <vector>

#include "carom/controllers/confirmation.h"
#include "carom/controllers/free_controller.h"
#include "carom/pool/cue_pull.h"
#include "carom/pool/person_stroke.h"
#include "carom/pool/pool_aim.h"
#include "carom/pool/pool_players.h"

/// Pool: aiming by keys and mouse, ball in hand, choices, the AI player, and the referee's rulings.
/// It works at any table with a cue; without a game, every ball at rest can be placed, and shot.
namespace carom {

class PoolController : public FreeController {
  public:
    /// Pre: PoolAim::is_at() the session's scene.
    explicit PoolController(const Session& session)
        : kind_(std::holds_alternative<PoolPlay>(session.game()) ? PlayKind::pool : PlayKind::cue),
          aim_(session) {}

    PlayKind kind() const override { return kind_; }
    bool take(PlayContext& play, const InputEvent& event) override;
    void perform(PlayContext& play, const Action& action) override;
    void point(PlayContext& play) override;
    void pass(PlayContext& play, double seconds) override;
    void after_ticks(PlayContext& play, double seconds) override;
    bool has_work() const override {
        return aim_.has_work() || coach_.is_asked() || stroke_.meter();
    }
    Camera fit(const PlayContext& play, const CellArea& area, double aspect) override;
    void cut_panel(const PlayContext& play, CellArea& area) override;
    void draw_panel(const PlayContext& play, Canvas& canvas) const override;
    void look(PlayContext& play) override;
    void annotate(const PlayContext& play, Annotations& annotations) const override;
    void add_status(const PlayContext& play, HudInfo& info) const override;
    void add_hints(const PlayContext& play, std::vector<KeyHelp>& hints) const override;
    bool has_all_hints() const override { return stroke_.meter() != nullptr; }
    std::vector<HelpWords> help_words(const PlayContext& play) const override;
    void continue_from(PlayContext& play, const Controller& before) override;
    bool drags_anything() const override { return false; }

    // For pool_actions.h.
    PoolAim& aim() { return aim_; }
    const PoolAim& aim() const { return aim_; }
    PersonStroke& stroke() { return stroke_; }
    PoolCoach& coach() { return coach_; }
    Confirmation& confirmation() { return confirmation_; }
    /// Who plays, and what is kept of it.
    PoolPlayers& players() { return players_; }
    const PoolPlayers& players() const { return players_; }
    /// Whether the player could strike now, with a key or the mouse.
    bool is_striking(const PlayContext& play) const;
    /// Whether the player could strike now, and no stroke is in progress.
    bool is_aiming(const PlayContext& play) const;
    bool aims_with_keys(const PlayContext& play) const;
    /// Whether the mouse pulls the cue, so that only the mouse shoots.
    bool is_pulling(const PlayContext& play) const { return pull_ && play.pointer.tool.has_cue(); }
    /// The view was zoomed on the aim: the whole table comes back with the shot.
    void set_near() { is_near_ = true; }
    /// Shoots; in a match it starts the meter first. False: there is nothing to shoot now.
    bool shoot_with_key(PlayContext& play);

  protected:
    bool take_press(PlayContext& play, const InputEvent& event) override;
    bool take_release(PlayContext& play) override;

  private:
    bool takes_key(PlayContext& play, const InputEvent& event);
    bool takes_choice(PlayContext& play, const InputEvent& event);
    void shoot(PlayContext& play, const std::optional<Stroke>& stroke = std::nullopt);
    std::string line(const PlayContext& play) const;

    PlayKind kind_;
    PoolAim aim_;
    CellArea panel_;              ///< of the scoreboard; empty: none
    bool aims_by_mouse_ = false;  ///< the left button is down, and the cue points at the mouse
    PersonStroke stroke_;
    std::optional<CuePull> pull_{};
    std::optional<char32_t> chosen_by_{};  ///< the last key, if it picked a choice
    bool is_near_ = false;                 ///< the view was zoomed on the aim, for the next shot
    double after_ = 0.0;  ///< InputEvent::after of the event that is being handled, s
    PoolPlayers players_;
    PoolCoach coach_;
    Confirmation confirmation_;
};

/// Whether balls are in motion, so that no shot is due.
bool are_rolling(const PlayContext& play);
/// Whether the cue is in the player's hands, so that no key brings out the editor's cursor, even
/// while nothing can be aimed.
bool keeps_cue(const PlayContext& play);

}  // namespace carom
