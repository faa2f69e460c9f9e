#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "carom/context/companion.h"
#include "carom/context/conserved_reference.h"
#include "carom/context/controller.h"
#include "carom/context/key_map.h"
#include "carom/context/messages.h"
#include "carom/context/panels.h"
#include "carom/context/play_observer.h"
#include "carom/context/play_view.h"
#include "carom/context/playback_clock.h"
#include "carom/context/pointer_tool.h"
#include "carom/text/level_words.h"
#include "game/session/session.h"
#include "lab/run/notes.h"
#include "terminal/input/key_repeat.h"

/// The parts of a game in play: the data that actions and controllers work on. Each part has a
/// header of its own.
namespace carom {

/// A player's requests to the program around the game.
enum class PlayRequest : std::uint8_t {
    none,
    quit,
    menu,
    save,
    record,
    toggle_mouse,
    theme,
    change_key,
    resume
};

/// The pointer, moved by the mouse or the cursor keys, and the tool it holds.
struct Pointer {
    Vec2 at;  ///< in the world; of the mouse or the cursor, whichever moved last
    PointerTool tool;
    bool shows_cursor = false;
    bool cue_is_armed = false;  ///< the next press on a ball starts pulling the cue
    std::optional<CellPoint> panning_from{};
    std::optional<std::uint8_t> pressed{};  ///< the mouse button that the tool follows
};

/// A page that covers the game; the game waits meanwhile.
struct CoveringPage {
    enum class Kind : std::uint8_t { none, help, about, record, explanation, problems };
    Kind kind = Kind::none;
    int scroll = 0;
    int most = 0;  ///< as far as it scrolls; 0: all of it is visible

    bool is_open() const { return kind != Kind::none; }
    void open(Kind which) { *this = {.kind = which}; }
};

/// The known abilities of the terminal, and its bell.
struct TerminalState {
    bool mouse_is_off = false;
    bool tells_key_release = false;
    std::optional<KeyRepeatTimes> key_repeat{};  ///< as learnt; none: not known
    bool rings = false;        ///< the player wants the bell for kicks at a pinball table
    bool bell_is_due = false;  ///< to be rung once
};

struct PlayContext {
    PlayContext(Session session, const ViewOptions& view, KeyMap keys, bool solver_is_picked);
    // Defined in play_context.cpp: the code for so many members is then compiled once.
    PlayContext(PlayContext&& other) noexcept;
    PlayContext& operator=(PlayContext&& other) noexcept;
    ~PlayContext();

    Session session;
    LevelWords words;  ///< the level's own
    KeyMap keys;
    PlaybackClock clock;
    PlayView view;
    Pointer pointer;
    Companion companion;
    Panels panels;
    std::shared_ptr<PlayObserver> observation;  ///< shared with the session, never null
    ConservedReference reference;
    Messages messages;
    TickNotes notes;  ///< of the last tick of which the player was told
    CoveringPage page;
    TerminalState terminal;
    PlayRequest request = PlayRequest::none;
    KeepGoing keep_going;
    std::optional<Vec2> last_gravity;
    bool solver_is_picked = false;  ///< by carom, not by the level or the player
    bool needs_draw = true;         ///< a visible state has changed
    std::unique_ptr<Controller> controller;
};

/// `place`: in the world, where it happened; marked while the message is shown.
void say(PlayContext& play, std::string message, std::optional<Vec2> place = {});
void complain(PlayContext& play, std::string message, std::optional<Vec2> place = {});
void complain(PlayContext& play, const Complaint& complaint);

/// Applies a command and shows the message `done`, or the reason for the refusal.
void obey(PlayContext& play, const Command& command, std::string done);
/// Makes the present the reference for drift: see ConservedReference.
void set_reference(PlayContext& play);

/// Whether a recording is being watched: then keys control only time and view.
bool is_watching(const PlayContext& play);
/// Whether the game is paused and computes nothing.
bool is_idle(const PlayContext& play);
/// Advances the companion to the game's tick; false while it is still behind.
bool keep_up(PlayContext& play, const MayGoOn& may_go_on);

/// How close to the pointer an object must be to be picked, a length.
double slack(const PlayContext& play);
std::optional<BallId> ball_at_pointer(const PlayContext& play);
void move_pointer(PlayContext& play, Vec2 to);
/// Moves the cursor by so many cells, inside the camera's area, and shows it.
void move_cursor(PlayContext& play, double columns, double rows);

/// The name that the level gives a ball, else "ball N".
std::string name_of(const PlayContext& play, BallId ball);
/// " m/s", or empty where the level has natural units.
std::string_view speed_unit(const Scene& scene);

}  // namespace carom
