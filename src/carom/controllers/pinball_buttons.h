#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "game/commands/command.h"
#include "terminal/input/input.h"

/// The buttons of a pinball table: each is down while its key or its mouse button is held.
namespace carom {

/// Turns events into presses. Where the terminal reports key releases, a button is down until the
/// release. Elsewhere a press holds the button for a set time, and key repeats extend it: a flipper
/// stays up for 0.2 s, then as long as repeats arrive; the plunger is pulled until they stop, or
/// for 0.6 s.
class PinballButtons {
  public:
    /// Takes an event of the button's key. Returns the resulting changes.
    std::vector<command::Press> take(Button button, const InputEvent& event);
    /// Takes a press of a mouse button, whose release the terminal always reports. `mouse`: its
    /// number; 0: the terminal does not say.
    std::vector<command::Press> press_mouse(std::uint8_t mouse, Button button);
    std::vector<command::Press> release_mouse(std::uint8_t mouse);
    bool has_mouse() const;

    /// Toggle mode: a press of a flipper's key raises it, the next one lowers it.
    void set_toggles(bool toggles) { toggles_ = toggles; }
    bool toggles() const { return toggles_; }

    /// Returns the buttons that come up as `seconds` pass.
    std::vector<command::Press> pass(double seconds);
    /// Releases every button, for when the state of the keys is unknown.
    std::vector<command::Press> release_all();

    bool is_down() const;
    /// Whether the terminal reports key releases; if not set, the first release shows that it does.
    void set_tells_release(bool tells) { tells_release_ = tells; }
    bool tells_release() const { return tells_release_; }

  private:
    struct Held {
        bool is_down = false;
        double left = 0.0;                    ///< s until it comes up on its own
        double since = 1e9;                   ///< s since its last press or repeat
        std::optional<std::uint8_t> mouse{};  ///< the mouse button that holds it
    };
    std::array<Held, button_count> held_{};
    bool tells_release_ = false;
    bool toggles_ = false;
};

}  // namespace carom
