#pragma once

#include <optional>
#include <string>
#include <vector>

#include "carom/controllers/free_controller.h"
#include "carom/pool/person_stroke.h"
#include "carom/pool/pool_aim.h"
#include "carom/pool/pool_opponent.h"
#include "carom/pool/pool_status.h"
#include "carom/pool/shot_clock.h"
#include "carom/pool/shot_tally.h"

/// Pool: aiming by keys and mouse, ball in hand, choices, the AI player, and the referee's rulings.
/// It works at any table with a cue; without a game, balls can be dragged freely.
///
/// A game against carom, or with a length (race=), is a match: the stroke may fail, and there is
/// no undo, no coach and no forecast. All others are practice, where a shot is exactly as aimed.
namespace carom {

class PoolController : public FreeController {
  public:
    /// Whether the level has a cue, so that a player can aim.
    static bool is_at(const Scene& scene) { return PoolAim::is_at(scene); }
    /// Pre: is_at().
    explicit PoolController(const Session& session) : aim_(session) {}

    PlayKind kind() const override { return PlayKind::pool; }
    bool take(PlayContext& play, const InputEvent& event) override;
    void perform(PlayContext& play, const Action& action) override;
    void point(PlayContext& play) override;
    void pass(PlayContext& play, double seconds) override;
    void after_ticks(PlayContext& play, double seconds) override;
    bool has_work() const override {
        return aim_.has_work() || coach_.is_asked() || stroke_.meter();
    }
    void cut_panel(const PlayContext& play, CellArea& area) override;
    void draw_panel(const PlayContext& play, Canvas& canvas) const override;
    void look(PlayContext& play) override;
    void annotate(const PlayContext& play, Annotations& annotations) const override;
    void add_status(const PlayContext& play, HudInfo& info) const override;
    void add_hints(const PlayContext& play, std::vector<KeyHelp>& hints) const override;
    void continue_from(PlayContext& play, const Controller& before) override;
    bool drags_anything() const override { return false; }

    // Actions. Those that return false do nothing, because the key means something else at present.
    bool turn_coarsely(PlayContext& play, int direction);
    void turn_finely(PlayContext& play, int direction);
    bool change_speed(PlayContext& play, int direction);
    bool move_tip(const PlayContext& play, int side, int follow);
    bool shoot_with_key(PlayContext& play);
    bool edit_nothing(PlayContext& play) const;
    bool next_pot_under_rules(PlayContext& play, bool backwards);
    void skip_to_rest(PlayContext& play);
    bool give_up_stroke(PlayContext& play);
    void next_hand(PlayContext& play);
    void tell_record(PlayContext& play) const;
    bool explain_cue(PlayContext& play) const;
    void next_pot(PlayContext& play, bool backwards);
    void next_call(PlayContext& play);
    void next_aids(PlayContext& play);
    void place_cue_ball(PlayContext& play);
    void next_opponent(PlayContext& play);
    void ask_coach(PlayContext& play);
    void undo_shot(PlayContext& play);

    // State that is kept with an unfinished game.
    /// The AI player plays the second player from now on (PoolOpponent::set_skill). False without a
    /// game of pool.
    bool set_opponent(const Session& session, int skill);
    int opponent() const { return opponent_.skill(); }
    /// On the shot clock, s; none: no clock runs.
    std::optional<double> time_left(const Session& session) const { return clock_.left(session); }
    void set_time_left(const Session& session, double left) { clock_.resume(session, left); }
    /// The level of the person's hand in a match, least_hand..most_hand.
    int hand() const { return stroke_.level(); }
    void set_hand(int level) { stroke_.set_level(level); }
    /// What the person had done in matches before this game, for tell_record().
    void set_record(const PoolRecord& record) { record_ = record; }
    ShotTally& tally() { return tally_; }
    const ShotSetup& setup() const { return aim_.setup(); }
    void set_up(const Session& session, const ShotSetup& setup) { aim_.set_up(session, setup); }

  protected:
    bool take_press(PlayContext& play, const InputEvent& event) override;
    bool take_release(PlayContext& play) override;

  private:
    bool is_aiming(const PlayContext& play) const;
    bool aims_with_keys(const PlayContext& play) const;
    bool are_rolling(const PlayContext& play) const;
    bool keeps_cue(const PlayContext& play) const;
    void count_time(PlayContext& play, double seconds);
    void tally(const PlayContext& play, double seconds);
    bool is_match(const Session& session) const;
    bool is_striking(const PlayContext& play) const;
    bool takes_key(PlayContext& play, const InputEvent& event);
    void start_push(PlayContext& play);
    void shoot(PlayContext& play, const std::optional<Stroke>& stroke = std::nullopt);
    void hear_coach(PlayContext& play);
    PlayerNames names() const;
    std::string line(const PlayContext& play) const;

    PoolAim aim_;
    CellArea panel_;              ///< of the scoreboard; empty: none
    bool aims_by_mouse_ = false;  ///< the left button is down, and the cue points at the mouse
    ShotAnnouncer announcer_;
    PersonStroke stroke_;
    double after_ = 0.0;  ///< InputEvent::after of the event that is being handled, s
    ShotClock clock_;
    ShotTally tally_;
    PoolRecord record_;
    PoolOpponent opponent_;
    PoolCoach coach_;
};

/// Whether a match has begun and is not won, so that it is kept when the player leaves.
bool is_in_match(const Session& session);

}  // namespace carom
