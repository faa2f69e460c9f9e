#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carom/controllers/pinball_buttons.h"
#include "game/session/session.h"

/// Input at a pinball table: keys and mouse press buttons. The caller applies the returned
/// commands.
namespace carom {

class PinballInput {
  public:
    /// Takes an event of a button's key.
    std::vector<command::Press> take_key(Button button, const InputEvent& event) {
        return buttons_.take(button, event);
    }
    /// A press of a key without a button.
    void take_other_key(const InputEvent& event) { buttons_.take_other_key(event); }
    /// Lets go of the plunger, whether or not its key is still held.
    std::vector<command::Press> let_go_of_plunger() { return buttons_.let_go(Button::plunger); }
    /// Left mouse button: left flipper; right: right flipper; middle: plunger. A press of the left
    /// button on a plunger with a ball pulls that plunger. `at`: the mouse position in the world.
    /// None: the event is not for the table.
    std::optional<std::vector<command::Press>> take_mouse(const InputEvent& event, Vec2 at,
                                                          const Session& session);
    /// While the plunger is dragged, the mouse pulls it by hand: the further, the stronger. `row`:
    /// height of a row of the screen, length. None: the event is not for the plunger.
    std::optional<command::Pull> drag_plunger(const InputEvent& event, Vec2 at, double row);

    /// Returns the buttons that come up as `seconds` pass.
    std::vector<command::Press> pass(double seconds, bool is_paused) {
        return buttons_.pass(seconds, is_paused);
    }
    /// Releases every button.
    std::vector<command::Press> release_all() { return buttons_.release_all(); }

    /// Switches between flippers that toggle and flippers that are up only while held. Returns the
    /// new mode as a sentence.
    std::string next_flipper_mode();
    /// The current mode, for the status line: "Hold to keep up (a tap lasts 0.70 s).".
    std::string flipper_mode() const;
    /// The terminal reports key releases.
    void set_tells_release() { buttons_.set_tells_release(true); }
    /// How the terminal repeats keys, as learnt in earlier games, and as known now.
    void remember(const KeyRepeatTimes& times) { buttons_.remember(times); }
    const std::optional<KeyRepeatTimes>& key_repeat() const { return buttons_.repeat().times(); }

  private:
    /// The plunger that the mouse holds, from where, and whether it has been dragged.
    struct Grip {
        Vec2 from;
        Vec2 direction;  ///< in which the plunger sends balls
        bool has_pulled = false;
    };
    PinballButtons buttons_;
    std::optional<Grip> grip_;
};

}  // namespace carom
