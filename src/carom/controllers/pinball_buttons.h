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

/// Turns events into presses. Where the terminal reports the release of a key, a button is down
/// until then. Elsewhere a press holds the button for a set time, and repeats of the key hold it
/// longer: a flipper for 0.2 s, then as long as repeats arrive; the plunger until they stop, or for
/// 0.6 s.
class PinballButtons {
  public:
    /// An event of the button's key. What it changes.
    std::vector<command::Press> take(Button button, const InputEvent& event);
    /// The mouse always reports a release. `mouse`: which of its buttons; 0: the terminal does not
    /// say.
    std::vector<command::Press> press_mouse(std::uint8_t mouse, Button button);
    std::vector<command::Press> release_mouse(std::uint8_t mouse);
    bool has_mouse() const;

    /// A press of a flipper's key raises it, the next one lowers it.
    void set_toggles(bool toggles) { toggles_ = toggles; }
    bool toggles() const { return toggles_; }

    /// The buttons that come up as `seconds` pass.
    std::vector<command::Press> pass(double seconds);
    /// Every button comes up: it is not known what became of the keys.
    std::vector<command::Press> let_go();

    bool is_down() const;
    /// The terminal reports releases of keys; else the first release shows that it does.
    void set_tells_release(bool tells) { tells_release_ = tells; }
    bool tells_release() const { return tells_release_; }

  private:
    struct Held {
        bool is_down = false;
        double left = 0.0;                    ///< s until it comes up by itself
        double since = 1e9;                   ///< s since its last press or repeat
        std::optional<std::uint8_t> mouse{};  ///< its button that holds it
    };
    std::array<Held, button_count> held_{};
    bool tells_release_ = false;
    bool toggles_ = false;
};

}  // namespace carom
