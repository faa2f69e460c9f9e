#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "carom/context/comparison_run.h"
#include "carom/context/ensemble.h"
#include "carom/context/keys.h"
#include "carom/context/playback_clock.h"
#include "carom/context/pointer_tool.h"
#include "carom/controllers/pool_ai.h"
#include "carom/controllers/pool_controller.h"
#include "carom/controllers/table_controller.h"
#include "game/session/session.h"
#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/draw/draw.h"
#include "terminal/input/input.h"
#include "terminal/panels/energy.h"
#include "terminal/panels/hud.h"
#include "terminal/panels/split.h"

/// One game being played: takes what the person does, lets time pass, and draws. Knows no terminal,
/// no files and no clock, so tests play it as a person would.
namespace carom {

/// What the player asks of the program around the game.
enum class PlayRequest : std::uint8_t { none, quit, menu, save, toggle_mouse, resume };

class Player {
  public:
    /// `solver_is_picked`: by carom, not by the level or the person.
    Player(Session session, const ViewOptions& view, KeyMap keys, bool solver_is_picked = false);

    /// One key, or one report of the mouse. Other events do nothing.
    PlayRequest handle(const InputEvent& event);
    PlayRequest perform(Action action);

    /// Lets `seconds` of the person's time pass: ticks, and messages that fade. Nothing happens
    /// while the window is too small or help is shown.
    void advance(double seconds, const MayGoOn& may_go_on);

    /// Draws all of the window. `aspect`: height of a cell over its width.
    void draw(Canvas& canvas, double aspect);
    /// Something that is drawn has changed since the last draw().
    bool needs_draw() const { return needs_draw_; }
    void touch() { needs_draw_ = true; }
    /// How long nothing will change by itself, s: 0 while ticks are run; infinite in a pause.
    double seconds_to_change() const;
    /// Motion of the mouse without a button matters now.
    bool wants_motion() const;

    /// Asked now and then within long ticks; false gives them up.
    void set_keep_going(const KeepGoing& keep_going);

    void say(std::string message);
    void complain(std::string message);
    /// Stays until the next call; none: all is well. For the errors of a level that is watched.
    void set_problem(std::optional<std::string> problem);

    /// From now on carom plays the second player, with that steadiness; 0: a person does. False
    /// where no game of pool is played.
    bool set_opponent(int steadiness);

    void pause(bool paused);
    /// Of carom's hands, the one that plays the second player; 0: a person does.
    int opponent() const { return opponent_ ? opponent_->steadiness() : 0; }
    /// How the person stands at a pool table; none elsewhere.
    std::optional<PoolStance> stance() const;
    void stand(const PoolStance& stance);
    /// A match of pool has begun and is not won, so it is worth going on with another day.
    bool is_in_match() const;

    /// At a table of pinball: carom plays by itself.
    void demonstrate(bool does);
    void set_high_scores(HighScores scores);
    /// The terminal tells when a key is let go.
    void set_key_release(bool tells);
    /// At a table of pinball: the terminal's bell rings for what kicks.
    void set_bell(bool rings) { has_bell_ = rings; }
    bool has_bell() const { return has_bell_; }
    /// Whether it shall ring now, once.
    bool take_bell();
    /// A line for the table of honour, once.
    std::optional<HighScore> take_high_score();
    const Session& session() const { return session_; }
    /// A recording is watched: only time and view obey the keys.
    bool is_watching() const { return session_.is_following(); }
    const PlaybackClock& clock() const { return clock_; }
    const ViewOptions& view() const { return view_; }
    const PointerTool& tool() const { return tool_; }
    /// Where the person points, in the world: the mouse or the cursor, whichever moved last.
    Vec2 pointer() const { return pointer_; }
    const Camera& camera() const { return camera_; }
    /// After preferences or the terminal have changed.
    void set_view(const ViewOptions& view);
    void set_mouse_is_off(bool is_off) { mouse_is_off_ = is_off; }

    /// The same scene, changed on disk: another game, seen as this one was.
    Player continued_with(Session session, bool solver_is_picked) const;

  private:
    // player.cpp: time
    void perform_in_time(Action action);
    PlayRequest escape();
    void go_to(std::uint64_t tick);
    void second(int direction);
    bool step();
    void prepare();
    void tell_outcome();

    // player_world.cpp: solver and gravity
    void perform_on_world(Action action);
    void next_solver();
    void set_gravity(std::optional<Vec2> gravity);
    void obey(const Command& command, std::string done);

    // player_view.cpp: how it is seen
    void perform_on_view(Action action);
    void next_overlay();

    // player_hands.cpp: balls and edges by keys
    void perform_by_hand(Action action);
    void add_ball();
    void remove_at_pointer(bool only_edges);
    void draw_edge();
    void use_cue();
    void grab();
    void jump_to_ball(bool backwards);

    // player_mouse.cpp: the mouse and the cursor
    void handle_mouse(const InputEvent& event);
    void press(const InputEvent& event);
    void release(const InputEvent& event);
    void move_pointer(Vec2 to);
    void move_cursor(double columns, double rows);
    void zoom(CellPoint fixed, double factor);
    void pan(double columns, double rows);
    void scroll_page(const InputEvent& event);
    double slack() const;
    std::optional<BallId> ball_at_pointer() const;
    bool stands_still() const { return clock_.is_paused() && !clock_.is_seeking(); }

    // player_beside.cpp: another solver, or the butterfly, beside the game
    void next_comparison();
    void toggle_butterfly();
    bool keep_up(const MayGoOn& may_go_on);
    bool is_ahead() const;
    std::string beside() const;
    void draw_comparison(Canvas& canvas);
    CellPoint in_first_half(CellPoint place) const;

    // player_table.cpp: a pinball table
    const PinballState* pinball() const;
    bool handle_at_table(const InputEvent& event);
    bool handle_table_mouse(const InputEvent& event);
    void press_buttons(const std::vector<command::Press>& presses);
    void play_demonstration();
    void hear_table(double seconds);
    std::string hold_line() const;
    std::string score_line() const;  ///< empty where no points are counted
    void add_table_hints(std::vector<KeyHelp>& hints) const;

    // player_pool.cpp: a pool table
    const PoolPlay* pool() const;
    bool is_aiming() const;
    bool perform_at_pool(Action action);
    void aim_by_key(double degrees, double speed);
    bool move_tip(Action action);
    void shoot();
    void place_cue_ball();
    bool choose(const InputEvent& event);
    bool press_at_pool(const InputEvent& event);
    bool release_at_pool();
    void hear_referee();
    PlayerNames names() const;
    std::string pool_title() const;
    std::string pool_line() const;
    std::optional<std::string> clock_warning() const;
    std::vector<KeyHelp> pool_hints() const;
    bool is_opponents_turn() const;
    void next_opponent();
    void play_opponent(double seconds);
    void ask_coach();
    void hear_coach();
    void undo();

    // player_picture.cpp: drawing
    void lay_out(const Canvas& canvas, double aspect);
    Marks marks() const;
    HudInfo hud() const;
    std::vector<HudCheck> checks() const;
    std::vector<KeyHelp> hints() const;
    std::string mode() const;
    void draw_panels(Canvas& canvas);
    void draw_page(Canvas& canvas);
    std::vector<std::string> explanation_lines() const;
    void draw_game(Canvas& canvas, double aspect);
    std::string_view speed_unit() const;
    bool has_histogram() const;

    /// The sums at the last moment when something from outside changed them.
    struct Reference {
        std::uint64_t tick = 0;
        double energy = 0.0;
        Vec2 momentum;
        double momentum_scale = 0.0;  ///< sum of magnitudes
    };
    void set_reference();
    void watch_commands();

    Session session_;
    PlaybackClock clock_;
    PointerTool tool_;
    KeyMap keys_;
    std::optional<TableSeat> table_;
    std::string heard_;  ///< what the referee said last
    std::optional<PoolAim> seat_;
    std::optional<PoolAi> opponent_;
    double opponent_waits_ = 0.0;  ///< s until it shoots, once it has decided
    std::string opponent_says_;    ///< what it shoots; empty: it thinks
    std::optional<PoolAi> coach_;
    bool coach_is_asked_ = false;
    std::size_t coach_told_ = 0;  ///< thoughts
    bool aims_by_mouse_ = false;  ///< the left button is down, and the cue points at the mouse

    ViewOptions view_;
    ViewMemory memory_;
    Camera camera_;
    bool is_fitted_ = true;
    std::optional<ComparisonRun> comparison_;
    std::optional<Ensemble> ensemble_;
    ViewMemory comparison_memory_;
    Split split_;  ///< with a rival
    CellArea histogram_area_;
    CellArea energy_area_;
    bool shows_histogram_ = false;
    bool shows_energy_ = false;
    EnergyHistory energy_;
    Reference reference_;
    std::size_t commands_watched_ = 0;
    bool solver_is_picked_ = false;

    Vec2 pointer_;
    bool shows_cursor_ = false;
    std::optional<BallId> selected_;
    bool follows_ = false;
    bool cue_is_armed_ = false;  ///< the next press on a ball pulls the cue
    std::optional<CellPoint> panning_from_;
    std::optional<std::uint8_t> pressed_;  ///< the button that the hand follows
    std::optional<Vec2> last_gravity_;

    enum class Page : std::uint8_t { none, help, explanation };
    Page page_ = Page::none;  ///< over the game
    int page_scroll_ = 0;
    bool is_too_small_ = false;
    bool mouse_is_off_ = false;
    bool key_release_ = false;
    bool has_bell_ = false;
    bool bell_is_due_ = false;
    bool needs_draw_ = true;
    KeepGoing keep_going_;

    std::string message_;
    bool message_is_error_ = false;
    double message_seconds_ = 0.0;  ///< left
    std::optional<std::string> problem_;
};

/// Whether a tick that is being computed shall be given up for it: not for the motion of a mouse
/// and the like, which waits until the tick is done.
bool ends_tick(const InputEvent& event, const KeyMap& keys);

/// The solver of this kind as the level wants it, if it says so, else as it comes.
SolverSettings settings_of(SolverKind kind, const Scene& scene);

/// "swept", "substep 4x15": a solver with the settings that it has.
std::string solver_text(const SolverSettings& settings);

}  // namespace carom
