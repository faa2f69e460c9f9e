#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carom/controllers/pinball_buttons.h"
#include "game/session/session.h"

/// How a player presses the buttons of a pinball table, with keys or with the mouse. What the calls
/// return is for the caller to apply.
namespace carom {

class PinballInput {
  public:
    /// An event of a button's key.
    std::vector<command::Press> take_key(Button button, const InputEvent& event) {
        return buttons_.take(button, event);
    }
    /// The left button of the mouse is the left flipper, the right one the right flipper, the
    /// middle one the plunger; where a ball lies on the plunger, a press of the left button there
    /// pulls it. `at`: where the mouse is, in the world. None: the press is meant for something
    /// else.
    std::optional<std::vector<command::Press>> take_mouse(const InputEvent& event, Vec2 at,
                                                          const Session& session);
    /// A press on the plunger that is dragged pulls it by hand: the further, the stronger.
    /// `row`: height of a row of the screen, length. None: the event is meant for something else.
    std::optional<command::Pull> drag_plunger(const InputEvent& event, Vec2 at, double row);

    /// The buttons that come up as `seconds` pass.
    std::vector<command::Press> pass(double seconds) { return buttons_.pass(seconds); }
    /// Every button comes up.
    std::vector<command::Press> release_all() { return buttons_.let_go(); }

    /// Flippers stay where a press puts them, or are up only while it lasts. Returns the mode in
    /// force now, as a sentence.
    std::string next_flipper_mode();
    /// The mode in force, for the status line: "up while held".
    std::string flipper_mode() const;
    /// The terminal tells when a key is let go.
    void set_tells_release() { buttons_.set_tells_release(true); }

  private:
    /// The mouse has pressed on the plunger here, and has dragged it or not.
    struct Grip {
        Vec2 from;
        Vec2 direction;  ///< in which balls are sent
        bool has_pulled = false;
    };
    PinballButtons buttons_;
    std::optional<Grip> grip_;
};

}  // namespace carom
