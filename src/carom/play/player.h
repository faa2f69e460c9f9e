#pragma once

#include <optional>
#include <string>
#include <vector>

#include "carom/context/play_context.h"
#include "carom/controllers/pinball_scores.h"
#include "carom/pool/pool_players.h"
#include "game/pool/shot_setup.h"

/// A game being played: handles input, lets time pass, and draws. It knows no terminal, no files
/// and no clock, so tests play it as a person would. The table of actions (carom/context/action.h)
/// says what a key does; the controllers hold what differs between free play, pool, pinball and
/// watching.
namespace carom {

class Player {
  public:
    /// `solver_is_picked`: by carom, not by the level or the player.
    Player(Session session, const ViewOptions& view, KeyMap keys, bool solver_is_picked = false);

    /// Handles one key or mouse report. Other events do nothing.
    PlayRequest handle(const InputEvent& event);
    PlayRequest perform(const Action& action);

    /// `seconds` of wall-clock time pass for messages, which fade in a pause too.
    void fade_messages(double seconds);
    /// Lets `seconds` of wall-clock time pass: computes ticks. Does nothing while the window is too
    /// small or a page covers the game.
    void advance(double seconds, const MayGoOn& may_go_on);

    /// Draws the whole window. `aspect`: height of a cell over its width.
    void draw(Canvas& canvas, double aspect);
    /// Draws the scene as a whole into `area`, without status, aim and panels, for the menu.
    void draw_preview(Canvas& canvas, const CellArea& area, double aspect);
    /// The size of what draw_preview shows, in the level's lengths.
    Vec2 preview_size();
    /// Whether a visible state has changed since the last draw() or draw_preview().
    bool needs_draw() const { return play_.needs_draw; }
    /// The time for which nothing changes on its own, s: 0 while ticks run; infinite while paused.
    double seconds_to_change() const;
    /// Whether mouse motion without a button matters now.
    bool wants_motion() const;

    void say(std::string message);
    void complain(std::string message);
    /// See Messages::set_problem.
    void set_problem(std::vector<std::string> lines);

    /// See Messages::set_prompt.
    void set_prompt(std::string prompt);
    void pause(bool paused);
    /// Asked now and then within long ticks; false cancels the tick.
    void set_keep_going(const KeepGoing& keep_going);
    /// To be called after preferences or the terminal have changed.
    void set_view(const ViewOptions& view);
    void set_keys(const KeyMap& keys);
    /// What is known of the terminal, which the program sets and the game learns.
    TerminalState& terminal() { return play_.terminal; }
    const TerminalState& terminal() const { return play_.terminal; }
    /// Whether the bell should ring now; true once.
    bool take_bell();
    void set_high_scores(HighScores scores);

    /// Who plays at a pool table; null elsewhere.
    PoolPlayers* pool_players();
    const PoolPlayers* pool_players() const;
    /// The high scores of a pinball table that is played; null elsewhere.
    PinballScores* pinball_scores();
    const PinballScores* pinball_scores() const;
    /// Names the players of a recording. Pre: is_watching().
    void watch_opponent(int number);
    /// The shot that the player is setting up at a pool table; none elsewhere. It is kept with an
    /// unfinished game.
    std::optional<ShotSetup> shot_setup() const;
    void set_up(const ShotSetup& setup);

    /// Starts the demo at a pinball table.
    void demonstrate();
    bool is_demonstrating() const;

    const Session& session() const { return play_.session; }
    /// Whether a recording is being watched: then keys control only time and view.
    bool is_watching() const { return carom::is_watching(play_); }
    const PlaybackClock& clock() const { return play_.clock; }
    const ViewOptions& view() const { return play_.view.options; }
    const Pointer& pointer() const { return play_.pointer; }
    const Camera& camera() const { return play_.view.camera; }

    /// The level was changed on disk: a new game with the view of this one.
    Player continued_with(Session session, bool solver_is_picked) const;

  private:
    PlayContext play_;
    bool is_too_small_ = false;
};

/// The AI player at a pool table, by number; 0: none.
int opponent_of(const Player& player);

/// Whether this event should cancel a tick that is being computed. Mouse motion and the like wait
/// until the tick is done.
bool cancels_tick(const InputEvent& event, const KeyMap& keys);

}  // namespace carom
