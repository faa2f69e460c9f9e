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
#include "terminal/draw/pool_annotations.h"

/// The aim at a pool table: the shot that is being set up, its call, and the forecast of its
/// outcome. The controller (pool_controller.h) turns keys and mouse into calls.
namespace carom {

class PoolAim {
  public:
    /// Whether the level has a cue, so that a player can aim.
    static bool is_at(const Scene& scene) { return scene.pool.cue.has_value(); }
    /// Pre: is_at().
    explicit PoolAim(const Session& session);

    /// The ball that the cue strikes; none while it is pocketed.
    std::optional<BallId> cue_ball(const Session& session) const;
    /// Whether the player strikes one of several balls (Cue::balls), and chooses which.
    bool may_choose(const Session& session) const;
    /// Strikes this ball from now on. False: the player may not, and nothing changes.
    bool choose(const Session& session, BallId ball);
    /// The next of the balls that the player may strike. Pre: may_choose().
    void choose_next(const Session& session, bool backwards);
    /// Whether the balls are at rest and no choice is due.
    bool may_aim(const Session& session) const;
    /// Whether the cue ball is in hand, or there is no game, and it may be placed.
    bool may_place(const Session& session) const;

    /// In a match the ghost ball is drawn and the line of the ball that it meets, in a game of
    /// shots the ghost ball alone. Nothing that a forecast knows is shown.
    void set_match(bool is_match);

    void turn(double degrees);                  ///< counter-clockwise
    void change_speed(double by);               ///< length/s; clamped to the level's limits
    void move_tip(double side, double follow);  ///< in radii
    void aim_at(const Session& session, Vec2 place);
    /// Pulls the cue back along the aim by `pulled`, length, >= 0. The speed grows with it, and is
    /// full before the mouse has gone all of its `room`, length, >= `pulled`.
    void pull(const Session& session, double pulled, double room);
    /// The cue as it is drawn, from its tip to its butt. Pre: may_aim().
    PoolAnnotations::Line stick(const Session& session) const;
    /// Aims at the next ball that can be pocketed, the easiest first; in a match, full at the next
    /// ball that may be hit first, those in sight before those that lie hidden. Returns a
    /// description.
    std::string next_pot(const Session& session, bool backwards);

    /// Aims like a proposed shot; the cue ball stays where it is.
    void take(const Session& session, const CandidateShot& candidate);

    /// Calls the pocket at `place`. False if there is none, or the rules ask for no call.
    bool call_pocket(const Session& session, Vec2 place);
    /// Declares a safety or a push-out, or withdraws it. Returns a description of the declaration.
    std::string next_call(const Session& session);
    std::string next_aids(const Session& session);

    const ShotSetup& setup() const { return setup_; }
    /// Restores a shot setup in the present turn; values that do not fit the level are replaced.
    void set_up(const Session& session, const ShotSetup& setup);

    command::Strike strike(const Session& session) const;
    /// The commands of the shot: the call, where one is due, and the strike. Pre: may_aim().
    std::vector<Command> shot(const Session& session);

    /// Starts the turn when a new one has begun, and renews the forecast when balls or aim have
    /// changed. A turn from the position of the last shot (another try, or an undone shot) starts
    /// with the aim of that shot.
    void look(const Session& session);
    /// Computes one more shot of the scatter; false when it is complete.
    bool work(const Session& session);
    bool has_work() const;

    /// `aims`: it is the player's turn to aim, so the cue and the lines are drawn.
    PoolAnnotations annotations(const Session& session, bool aims) const;
    /// Speed, tip, cut angle and call, in one line.
    std::string line(const Session& session, const Look& look) const;

  private:
    using Intent = ShotSetup::Intent;

    PoolCall call(const Session& session) const;
    std::vector<BallId> targets(const Session& session) const;
    void begin_turn(const Session& session);
    bool aim_as_before(const Session& session);
    /// The aim with which a turn begins, until the player aims.
    void aim_first(const Session& session);
    void aim_at_corner(const Session& session);
    void aim_at_nearest(const Session& session);
    Aids shown_aids() const;
    bool shows_object_line(const Session& session) const;
    std::string next_target(const Session& session, bool backwards);
    std::optional<int> marked_pocket(const Session& session) const;

    ShotSetup setup_;
    std::optional<BallId> chosen_;  ///< of several; void in another player's turn
    bool is_match_ = false;
    bool has_aimed_ = false;  ///< the player has aimed in this turn, so the bearing is kept
    /// The last shot, and where it was played from.
    struct Played {
        std::vector<Vec2> places;  ///< places_of_balls()
        ShotSetup setup;
    };
    std::optional<Played> played_;
    std::size_t pot_ = 0;
    std::string pot_text_;

    // The inputs of the forecast, and the forecast.
    std::vector<Vec2> positions_;
    ShotSetup seen_setup_;
    bool is_seen_ = false;
    std::uint64_t turn_ = ~std::uint64_t{0};
    std::optional<Forecast> forecast_;
    std::vector<PoolAnnotations::Spot> cloud_;
    std::uint64_t cloud_shots_ = 0;
};

/// The cue of the player in turn. Pre: PoolAim::is_at() the session's scene.
const Cue& cue_in_turn(const Session& session);
/// Where the balls are, in an order of its own: a ball that returns to the table has a new id.
std::vector<Vec2> places_of_balls(const Session& session);
/// The numbers on the balls, if a game or a rack gives them any.
std::vector<PoolAnnotations::Number> numbers_of(const Session& session);
/// The balls of a game that have returned to the table.
std::vector<PoolAnnotations::Returned> returned_of(const Session& session);

}  // namespace carom
