#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "game/ai/planner.h"
#include "game/pool/pool.h"
#include "game/pool/pool_words.h"
#include "game/pool/shot_setup.h"
#include "game/session/forecast.h"
#include "game/session/session.h"
#include "terminal/canvas/palette.h"
#include "terminal/draw/pool_marks.h"

/// The aim at a pool table: the shot that is being set up, what it calls, and the forecast of what
/// it will do. The controller (pool_controller.h) turns keys and the mouse into calls.
namespace carom {

class PoolAim {
  public:
    /// The level has a cue, so there is something to aim.
    static bool is_at(const Scene& scene) { return scene.pool.cue.has_value(); }
    /// Pre: is_at().
    explicit PoolAim(const Session& session);

    /// The ball that the cue strikes; none while it is off the table.
    std::optional<BallId> cue_ball(const Session& session) const;
    /// The balls lie still, and no choice is due first.
    bool may_aim(const Session& session) const;
    /// The cue ball is in hand and may be placed.
    bool may_place(const Session& session) const;

    void turn(double degrees);                  ///< counter-clockwise
    void change_speed(double by);               ///< length/s; within what the level's cue gives
    void move_tip(double side, double follow);  ///< in shares of the radius
    void aim_at(const Session& session, Vec2 place);
    /// The cue is pulled back to `hand`: the ball goes the other way, the longer the pull, the
    /// faster.
    void pull(const Session& session, Vec2 hand);
    /// Aims at the next way to pocket a ball, the easiest first. Returns it in words.
    std::string next_pot(const Session& session, bool backwards);

    /// Aims as a proposed shot does; the cue ball stays where it is.
    void take(const Session& session, const CandidateShot& thought);

    /// Calls the pocket that is there. False when there is none, or nothing is called.
    bool call_pocket(const Session& session, Vec2 place);
    /// Declares a safety, or a push-out, or takes it back. Returns in words what is declared now.
    std::string next_call(const Session& session);
    std::string next_aids();
    Aids aids() const { return setup_.aids; }

    const ShotSetup& setup() const { return setup_; }
    /// Restores a shot setup in the present turn; what does not fit the level is replaced.
    void set_up(const Session& session, const ShotSetup& setup);

    command::Strike strike(const Session& session) const;
    /// The call, where one is due, and the strike. Pre: may_aim().
    std::vector<Command> shot(const Session& session);

    /// Starts the turn where a new one has begun, and renews the forecast where balls or aim
    /// changed.
    void look(const Session& session);
    /// Computes one more shot of the scatter; false when none is left.
    bool work(const Session& session);
    bool has_work() const;

    /// `aims`: it is the player's turn to aim, so the cue and the lines are shown.
    PoolMarks marks(const Session& session, bool aims) const;
    /// Speed, tip, cut angle and call in one line.
    std::string line(const Session& session, const Look& look) const;

  private:
    using Intent = ShotSetup::Intent;

    const PoolPlay* play(const Session& session) const;
    PoolCall call(const Session& session) const;
    std::vector<BallId> targets(const Session& session) const;
    void begin_turn(const Session& session);
    void aim_at_nearest(const Session& session);
    double most_speed(const Session& session) const;

    ShotSetup setup_;
    bool has_aimed_ = false;  ///< in this turn: the bearing is the player's
    std::size_t pot_ = 0;
    std::string pot_text_;

    // What the forecast was computed from, and the forecast.
    std::vector<Vec2> lay_;
    ShotSetup seen_setup_;
    bool is_seen_ = false;
    std::uint64_t turn_ = ~std::uint64_t{0};
    std::optional<Forecast> forecast_;
    std::vector<PoolMarks::Spot> cloud_;
    std::uint64_t cloud_shots_ = 0;
};

/// The numbers on the balls, where a game or a rack gives them any.
std::vector<PoolMarks::Number> numbers_of(const Session& session);

}  // namespace carom
