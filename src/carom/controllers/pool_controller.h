#pragma once

#include <optional>
#include <string>
#include <vector>

#include "carom/controllers/free_controller.h"
#include "carom/controllers/pool_aim.h"
#include "carom/controllers/pool_opponent.h"
#include "carom/controllers/pool_status.h"

/// Pool: the aim by keys and by mouse, the ball in hand, choices, the AI player, and what the
/// referee says. Works at any table with a cue; where no game is played, balls are dragged as in
/// free play.
namespace carom {

class PoolController : public FreeController {
  public:
    /// The level has a cue, so there is something to aim.
    static bool is_at(const Scene& scene) { return PoolAim::is_at(scene); }
    /// Pre: is_at().
    explicit PoolController(const Session& session) : aim_(session) {}

    bool take(PlayContext& play, const InputEvent& event) override;
    void perform(PlayContext& play, const Action& action) override;
    void point(PlayContext& play) override;
    void pass(PlayContext& play, double seconds) override;
    void after_ticks(PlayContext& play, double seconds) override;
    bool has_work() const override { return aim_.has_work() || coach_.is_asked(); }
    void look(PlayContext& play) override { aim_.look(play.session); }
    void mark(const PlayContext& play, Marks& marks) const override;
    void add_status(const PlayContext& play, HudInfo& info) const override;
    void add_hints(const PlayContext& play, std::vector<KeyHelp>& hints) const override;
    void continue_from(PlayContext& play, const Controller& before) override;
    bool drags_anything() const override { return false; }

    // Actions. Those that return false do nothing while the player has something else to do with
    // the key than to aim.
    bool turn_coarsely(const PlayContext& play, int direction);
    void turn_finely(PlayContext& play, int direction);
    bool change_speed(const PlayContext& play, int direction);
    bool move_tip(const PlayContext& play, int side, int follow);
    bool shoot_with_key(PlayContext& play);
    bool explain_cue(PlayContext& play) const;
    void next_pot(PlayContext& play, bool backwards);
    void next_call(PlayContext& play);
    void next_aids(PlayContext& play);
    void place_cue_ball(PlayContext& play);
    void next_opponent(PlayContext& play);
    void ask_coach(PlayContext& play);
    void undo_shot(PlayContext& play);

    // What is kept with an unfinished game.
    /// The AI player takes the second player's turns from now on (PoolOpponent::set_steadiness).
    /// False where no game of pool is played.
    bool set_opponent(const Session& session, int steadiness);
    int opponent() const { return opponent_.steadiness(); }
    const ShotSetup& setup() const { return aim_.setup(); }
    void set_up(const Session& session, const ShotSetup& setup) { aim_.set_up(session, setup); }

  protected:
    bool take_press(PlayContext& play, const InputEvent& event) override;
    bool take_release(PlayContext& play) override;

  private:
    bool is_aiming(const PlayContext& play) const;
    bool aims_with_keys(const PlayContext& play) const;
    void shoot(PlayContext& play);
    void hear_coach(PlayContext& play);
    PlayerNames names() const;
    std::string line(const PlayContext& play) const;

    PoolAim aim_;
    bool aims_by_mouse_ = false;  ///< the left button is down, and the cue points at the mouse
    ShotAnnouncer announcer_;
    PoolOpponent opponent_;
    PoolCoach coach_;
};

/// A match has begun and is not won, so it is kept when the player leaves.
bool is_in_match(const Session& session);

}  // namespace carom
