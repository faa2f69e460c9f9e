#pragma once

#include <optional>
#include <string>

#include "carom/context/play_context.h"
#include "game/pool/shot_setup.h"

/// A game being played: takes what the player does, lets time pass, and draws. It knows no
/// terminal, no files and no clock, so tests play it as a person would. What a key does stands in
/// the table of actions (carom/context/action.h); what differs between free play, pool, pinball and
/// watching, in the controllers.
namespace carom {

class Player {
  public:
    /// `solver_is_picked`: by carom, not by the level or the player.
    Player(Session session, const ViewOptions& view, KeyMap keys, bool solver_is_picked = false);

    /// One key, or one report of the mouse. Other events do nothing.
    PlayRequest handle(const InputEvent& event);
    PlayRequest perform(const Action& action);

    /// Lets `seconds` of the player's time pass: ticks, and messages that fade. Nothing happens
    /// while the window is too small or a page covers the game.
    void advance(double seconds, const MayGoOn& may_go_on);

    /// Draws all of the window. `aspect`: height of a cell over its width.
    void draw(Canvas& canvas, double aspect);
    /// Something that is drawn has changed since the last draw().
    bool needs_draw() const { return play_.needs_draw; }
    /// How long nothing will change by itself, s: 0 while ticks are run; infinite in a pause.
    double seconds_to_change() const;
    /// Motion of the mouse without a button matters now.
    bool wants_motion() const;

    void say(std::string message);
    void complain(std::string message);
    /// Stays until the next call; none: all is well. For the errors of a level that is watched.
    void set_problem(std::optional<std::string> problem);

    void pause(bool paused);
    /// Asked now and then within long ticks; false gives them up.
    void set_keep_going(const KeepGoing& keep_going);
    /// After preferences or the terminal have changed.
    void set_view(const ViewOptions& view);
    void set_mouse_is_off(bool is_off) { play_.terminal.mouse_is_off = is_off; }
    /// The terminal tells when a key is let go.
    void set_key_release(bool tells) { play_.terminal.tells_key_release = tells; }
    /// At a pinball table the terminal's bell rings for what kicks the ball.
    void set_bell(bool rings) { play_.terminal.rings = rings; }
    bool has_bell() const { return play_.terminal.rings; }
    /// Whether the bell shall ring now, once.
    bool take_bell();
    void set_high_scores(HighScores scores);

    // What is kept of an unfinished game beside its commands.
    /// The AI player takes the second player's turns from now on, with that steadiness; 0: a person
    /// does. False where no game of pool is played.
    bool set_opponent(int steadiness);
    int opponent() const;
    /// How the player is about to shoot at a pool table; none elsewhere.
    std::optional<ShotSetup> shot_setup() const;
    void set_up(const ShotSetup& setup);

    /// At a pinball table, the demonstration plays.
    void demonstrate();
    /// A score that the player has entered initials for, once.
    std::optional<HighScore> take_high_score();

    const Session& session() const { return play_.session; }
    /// A recording is watched: only time and view obey the keys.
    bool is_watching() const { return carom::is_watching(play_); }
    const PlaybackClock& clock() const { return play_.clock; }
    const ViewOptions& view() const { return play_.view.options; }
    const PointerTool& tool() const { return play_.pointer.tool; }
    /// Where the player points, in the world: the mouse or the cursor, whichever moved last.
    Vec2 pointer() const { return play_.pointer.at; }
    const Camera& camera() const { return play_.view.camera; }

    /// The same scene, changed on disk: another game, seen as this one was.
    Player continued_with(Session session, bool solver_is_picked) const;

  private:
    void handle_mouse(const InputEvent& event);
    void scroll_page(const InputEvent& event);
    void draw_page(Canvas& canvas);
    void draw_game(Canvas& canvas, double aspect);

    PlayContext play_;
    bool is_too_small_ = false;
};

/// Whether a tick that is being computed shall be given up for this event: not for the motion of a
/// mouse and the like, which waits until the tick is done.
bool ends_tick(const InputEvent& event, const KeyMap& keys);

}  // namespace carom
