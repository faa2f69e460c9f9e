#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "carom/files/level_source.h"
#include "carom/files/recording.h"
#include "carom/options/play_options.h"
#include "carom/play/file_watcher.h"
#include "carom/play/menu.h"
#include "carom/play/player.h"
#include "carom/play/preferences.h"
#include "carom/play/resume.h"
#include "carom/play/running_game.h"
#include "carom/play/settings_file.h"
#include "terminal/input/capabilities.h"

/// The whole program except the terminal and the clock: the page that is shown, and the files
/// around it. The page is the menu, a running game, a notice, or a game that is being resumed.
namespace carom {

/// Requests of the program to the screen.
struct ScreenRequests {
    bool mouse = true;    ///< false: the mouse is left to the terminal
    bool motion = false;  ///< motion without a button matters
};

class Program {
  public:
    Program(PlayOptions options, PreferencesText preferences);

    /// Opens the page that the options ask for. Returns the problems if a named level cannot be
    /// played (and is not under --watch).
    std::optional<Problems> start();

    void set_capabilities(const Capabilities& capabilities);
    /// `now`: s on a monotonic clock.
    void handle(const InputEvent& event, double now);
    /// Tells the player that so many events came faster than the game could handle them.
    void tell_dropped_input(std::size_t events);
    void advance(double seconds, double now, const MayGoOn& may_go_on);
    /// Asked now and then within long ticks, in whichever thread; false cancels the tick.
    void set_keep_going(const KeepGoing& keep_going);
    /// Whether a game is on the screen: then advance() may be called in another thread. While it
    /// runs, only cancels_tick() may be called.
    bool is_playing() const { return std::holds_alternative<RunningGame>(page_); }
    /// Whether this event should cancel a tick that is being computed.
    bool cancels_tick(const InputEvent& event) const;
    bool needs_draw() const;
    void draw(Canvas& canvas);
    /// The longest time to wait for input, s.
    double seconds_to_change(double now) const;

    /// Whether the terminal's bell should ring now; true once.
    bool take_bell();
    bool is_over() const { return is_over_; }
    ScreenRequests screen_requests() const;

    /// The game is interrupted: writes the files needed to resume it, and the recording.
    void interrupt();
    /// Whether the game that was left last can be resumed.
    bool is_kept() const { return is_kept_; }
    /// A recording that could not be written: told to the player once the screen is closed.
    const std::optional<std::string>& lost_recording() const { return lost_recording_; }

  private:
    /// A page of text. One about the errors of a level under --watch stays until they are fixed.
    struct Notice {
        std::string title;
        Problems lines;
        int scroll = 0;
        std::optional<LevelSource> source{};
        FileWatcher watch{};
        std::string entry{};  ///< the item of the menu that is selected afterwards
        bool needs_draw = true;

        /// Scrolls the text; false: the key does not scroll.
        bool scroll_with(const InputEvent& event);
        void draw(Canvas& canvas, const Look& look, bool is_tried_again);
    };
    /// An unfinished game that is being replayed up to the point of interruption.
    struct Resuming {
        InterruptedGame game;
        Replayer replayer;
        bool needs_draw = true;

        void draw(Canvas& canvas, const Look& look);
    };

    void show_menu(std::string_view choose);
    /// Opens a level. None: it is on the screen; else the problems.
    std::optional<Problems> open(const LevelSource& source);
    std::optional<Problems> open_recording(const std::string& path);
    void open_or_tell(const LevelSource& source);
    void watch_or_tell(const std::string& recording);
    void open_challenge(const Challenge& challenge);
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
    /// Changes to the next theme, and returns its name.
    std::string_view next_theme();

    PlayOptions options_;
    Preferences preferences_;
    std::vector<std::string> preference_problems_;
    SettingsFile settings_;
    Capabilities capabilities_;
    ViewOptions view_;  ///< by options and preferences: the default of each level
    std::map<std::string, ViewOptions> views_;  ///< by path: as they were left in this run
    ThemeChoice theme_;
    std::optional<Recording> recording_;  ///< of the current game, until it ends
    std::optional<std::string> lost_recording_;
    bool mouse_ = true;
    bool is_kept_ = false;
    bool is_over_ = false;
    double next_autosave_ = 0.0;
    double next_look_ = 0.0;  ///< time of the next check of watched files
    KeepGoing keep_going_;
    std::variant<std::monostate, Menu, RunningGame, Notice, Resuming> page_;
};

}  // namespace carom
