#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "terminal/input/input.h"
#include "terminal/panels/pages.h"

/// Which key does what. Every action has a name, for the preferences file, and keys of its own.
namespace carom {

enum class Action : std::uint8_t {
    // time
    pause,
    step_forward,
    step_back,
    next_collision,
    second_forward,
    second_back,
    slower,
    faster,
    normal_speed,
    restart,
    // hands
    cursor_left,
    cursor_right,
    cursor_up,
    cursor_down,
    next_ball,
    previous_ball,
    grab,
    cue,
    add_ball,
    remove,
    draw_edge,
    remove_edge,
    // pool
    aim_left,
    aim_right,
    next_pot,
    previous_pot,
    call,
    place_cue_ball,
    aids,
    next_frame,
    opponent,
    coach,
    undo,
    // world
    solver,
    gravity,
    turn_gravity,
    save,
    // view
    renderer,
    colors,
    trails,
    overlay,
    velocities,
    contacts,
    broad_phase,
    ids,
    grid,
    outlines,
    histogram,
    energy,
    zoom_in,
    zoom_out,
    pan_left,
    pan_right,
    pan_up,
    pan_down,
    fit,
    follow,
    split,
    butterfly,
    explain,
    // program
    mouse,
    resume,
    help,
    menu,
    quit
};

std::string_view name(Action action);  ///< "step-forward"
std::optional<Action> action_named(std::string_view name);
std::vector<std::string_view> action_names();

/// A key with what is held down with it. Shift counts only for keys without a character: a capital
/// letter is a key of its own.
struct Key {
    char32_t code = 0;
    std::uint8_t modifiers = no_modifier;

    friend bool operator==(const Key&, const Key&) = default;
};

/// The key of an event of kind `key`.
Key key_of(const InputEvent& event);

/// As in the preferences file: "a", "?", "space", "ctrl-x", "shift-up", "f1", "comma" (or ",").
std::optional<Key> key_named(std::string_view text);
std::string key_text(const Key& key);

/// Every key does one thing at most; an action may have several keys.
class KeyMap {
  public:
    KeyMap();  ///< the keys that carom comes with

    /// none: the key does nothing.
    void bind(const Key& key, std::optional<Action> action);
    std::optional<Action> action_of(const Key& key) const;
    /// In the order in which they were bound.
    std::vector<Key> keys_of(Action action) const;
    /// The first key, for hints; empty when there is none.
    std::string hint(Action action) const;

    /// All actions with their keys, and the mouse, for the help screen.
    std::vector<HelpSection> help() const;

  private:
    struct Binding {
        Key key;
        Action action;
    };
    std::vector<Binding> bindings_;
};

}  // namespace carom
