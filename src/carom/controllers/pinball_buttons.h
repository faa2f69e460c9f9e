#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "game/commands/command.h"
#include "terminal/input/input.h"
#include "terminal/input/key_repeat.h"

/// The buttons of a pinball table: each is down while its key or its mouse button is held.
namespace carom {

/// Turns events into presses. Where the terminal reports key releases, a button is down until the
/// release. Elsewhere only presses and repeats arrive, and a terminal repeats only the key pressed
/// last, so:
///
/// - All buttons held by keys stay down as long as the last key pressed may be held
///   (KeyRepeat::may_be_held_until), and come up together. A tap therefore counts as long as the
///   terminal takes to repeat.
/// - A flipper that is pressed again while it is up drops for a moment and flips again. A nudge
///   nudges again.
/// - A plunger that is pressed again is let go.
/// - A button that is held while the game is paused stays down until its key is pressed again,
/// which
///   takes it over: the key that resumes the game ends the repeats of all others. A tap shows no
///   repeats, so it is not held.
class PinballButtons {
  public:
    /// Takes an event of the button's key. Returns the resulting changes, in order.
    std::vector<command::Press> take(Button button, const InputEvent& event);
    /// A press of a key without a button: the terminal stops repeating the last one.
    void take_other_key(const InputEvent& event);
    /// Takes a press of a mouse button, whose release the terminal always reports. `mouse`: its
    /// number; 0: the terminal does not say.
    std::vector<command::Press> press_mouse(std::uint8_t mouse, Button button);
    std::vector<command::Press> release_mouse(std::uint8_t mouse);
    bool has_mouse() const;

    /// Toggle mode: a press of a flipper's key raises it, the next one lowers it.
    void set_toggles(bool toggles) { toggles_ = toggles; }
    bool toggles() const { return toggles_; }

    /// Returns the changes that are due as `seconds` pass.
    std::vector<command::Press> pass(double seconds, bool is_paused = false);
    /// Releases a button whose key may still be held: its repeats do nothing.
    std::vector<command::Press> let_go(Button button);
    /// Releases every button, for when the state of the keys is unknown.
    std::vector<command::Press> release_all();

    bool is_down() const;
    /// Whether the terminal reports key releases; if not set, the first release shows that it does.
    void set_tells_release(bool tells) { tells_release_ = tells; }
    bool tells_release() const { return tells_release_; }
    /// How this terminal repeats keys: what is known, and what was learnt in earlier games.
    const KeyRepeat& repeat() const { return repeat_; }
    void remember(const KeyRepeatTimes& times) { repeat_.remember(times); }

  private:
    struct Held {
        bool is_down = false;
        std::optional<double> rises_at{};     ///< dropped for a moment; back then
        std::optional<std::uint8_t> mouse{};  ///< the mouse button that holds it
        bool has_repeated = false;            ///< a key has repeated since it went down
        bool outlasts_pause = false;          ///< held since the game was paused
    };
    std::vector<command::Press> press_again(Button button, Held& held, double time) const;
    void note_repeat(bool repeats, Held& held);

    std::array<Held, button_count> held_{};
    KeyRepeat repeat_;
    double now_ = 0.0;  ///< s of the player's time
    bool tells_release_ = false;
    bool toggles_ = false;
};

}  // namespace carom
