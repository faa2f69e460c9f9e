#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "carom/files/level_source.h"
#include "carom/options/play_options.h"
#include "carom/play/file_watcher.h"
#include "carom/play/menu.h"
#include "carom/play/player.h"
#include "carom/play/preferences.h"
#include "carom/play/recording.h"
#include "carom/play/resume.h"
#include "carom/play/running_game.h"
#include "terminal/input/capabilities.h"

/// All of playing but the terminal and the clock: which page is shown, and the files around it. The
/// page is the menu, a running game, a notice, or a game that is being resumed.
namespace carom {

/// What the program asks of the screen.
struct ScreenRequests {
    bool mouse = true;    ///< false: the mouse is left to the terminal
    bool motion = false;  ///< and motion without a button matters
};

class Program {
  public:
    Program(PlayOptions options, PreferencesText preferences);

    /// Goes to the page that the options ask for. The problems when a level was named that cannot
    /// be played (and is not watched until it can).
    std::optional<Problems> start();

    void set_capabilities(const Capabilities& capabilities);
    /// `now`: s on a clock that does not go back.
    void handle(const InputEvent& event, double now);
    void advance(double seconds, double now, const MayGoOn& may_go_on);
    /// Asked now and then within long ticks, wherever they are computed; false gives them up.
    void set_keep_going(const KeepGoing& keep_going);
    /// A game is on the screen: then advance() may be called in another thread. While it runs,
    /// nothing else is called but ends_tick().
    bool is_playing() const { return std::holds_alternative<RunningGame>(page_); }
    /// Whether a tick that is being computed shall be given up for it.
    bool ends_tick(const InputEvent& event) const;
    bool needs_draw() const;
    void draw(Canvas& canvas);
    /// How long to wait for input at most, s.
    double seconds_to_change(double now) const;

    /// Whether the terminal's bell shall ring now, once.
    bool take_bell();
    bool is_over() const { return is_over_; }
    ScreenRequests screen_requests() const;

    /// The game is interrupted: writes what is needed to resume it, and the recording.
    void interrupt();
    /// The game that was left last can be resumed.
    bool is_kept() const { return is_kept_; }
    /// A recording that could not be written: for the player, once the screen is closed.
    const std::optional<std::string>& lost_recording() const { return lost_recording_; }

  private:
    /// A page of text; about a watched level with errors, it stays until they are fixed.
    struct Notice {
        std::string title;
        Problems lines;
        int scroll = 0;
        std::optional<LevelSource> source{};
        FileWatcher watch{};
        bool needs_draw = true;

        /// A key that moves the text; false: it is another key.
        bool scroll_with(const InputEvent& event);
        void draw(Canvas& canvas, const Look& look, bool is_tried_again);
    };
    /// An unfinished game that is being replayed up to where it stood.
    struct Resuming {
        InterruptedGame game;
        Replayer replayer;
        bool needs_draw = true;

        void draw(Canvas& canvas, const Look& look);
    };

    void show_menu(std::string_view choose);
    /// None: it is on; else the problems.
    std::optional<Problems> open(const LevelSource& source);
    std::optional<Problems> open_recording();
    void open_or_tell(const LevelSource& source);
    void resume(const InterruptedGame& game);
    void finish_resuming();
    void enter(LevelSource source, Player player, std::optional<InterruptedGame> offer);
    void leave_game();
    bool end_game();
    void tell(std::string title, Problems problems);

    void handle_game(RunningGame& game, const InputEvent& event, double now);
    void handle_notice(Notice& notice, const InputEvent& event);
    void handle_resuming(const InputEvent& event);
    void handle_menu(Menu& menu, const InputEvent& event);
    void advance_game(RunningGame& game, double seconds, double now, const MayGoOn& may_go_on);
    void advance_notice(Notice& notice, double now);
    void advance_resuming(Resuming& resuming, const MayGoOn& may_go_on);

    void reload(RunningGame& game);
    ViewOptions view() const;
    /// Writes what the player has changed by keys into the preferences file.
    void keep_preferences(const ViewOptions& before, const ViewOptions& after);
    void keep_setting(std::string_view name, std::string_view value);

    PlayOptions options_;
    Preferences preferences_;
    std::vector<std::string> preference_problems_;
    Capabilities capabilities_;
    ViewOptions view_;
    std::optional<Recording> recording_;  ///< of the game that is played, until it ends
    std::optional<std::string> lost_recording_;
    bool mouse_ = true;
    bool is_kept_ = false;
    bool has_told_lost_settings_ = false;  ///< once is enough
    bool is_over_ = false;
    double next_autosave_ = 0.0;
    double next_look_ = 0.0;  ///< at watched files
    KeepGoing keep_going_;
    std::variant<std::monostate, Menu, RunningGame, Notice, Resuming> page_;
};

}  // namespace carom
