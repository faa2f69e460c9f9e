#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "game/commands/command.h"
#include "terminal/input/input.h"

/// The buttons of a pinball table: each stays down as long as its key, or its button of the mouse,
/// is held.
namespace carom {

/// Turns events into presses. Where the terminal tells when a key is let go, a button is down until
/// then. Where it never has, a press holds the button for a set time, and the key's repeats hold it
/// on: a flipper for 0.2 s, then as long as repeats arrive; the plunger until they stop, or for
/// 0.6 s.
class PinballButtons {
  public:
    /// What an event of the button's key changes.
    std::vector<command::Press> take(Button button, const InputEvent& event);
    /// The mouse tells when it lets go. `mouse`: which of its buttons, 0 where it does not say.
    std::vector<command::Press> press_mouse(std::uint8_t mouse, Button button);
    std::vector<command::Press> release_mouse(std::uint8_t mouse);
    bool has_mouse() const;

    /// A press of a flipper's key raises it, the next one lowers it.
    void set_toggles(bool toggles) { toggles_ = toggles; }
    bool toggles() const { return toggles_; }

    /// What lets go as `seconds` pass.
    std::vector<command::Press> pass(double seconds);
    /// Lets go of everything: nobody has seen what became of the keys.
    std::vector<command::Press> let_go();

    bool is_down() const;
    /// The terminal says that it tells when a key is let go; else the first release teaches it.
    void set_tells_release(bool tells) { tells_release_ = tells; }
    bool tells_release() const { return tells_release_; }

  private:
    struct Held {
        bool is_down = false;
        double left = 0.0;                    ///< s until it lets go by itself
        double since = 1e9;                   ///< s since its last press or repeat
        std::optional<std::uint8_t> mouse{};  ///< its button that holds it
    };
    std::array<Held, button_count> held_{};
    bool tells_release_ = false;
    bool toggles_ = false;
};

}  // namespace carom
