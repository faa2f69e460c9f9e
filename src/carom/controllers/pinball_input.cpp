#include "carom/controllers/pinball_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "carom/controllers/free_controller.h"
#include "game/pinball/pinball.h"

namespace carom {
namespace {

// Rows of the screen over which the mouse pulls the plunger fully.
constexpr double full_pull_rows = 6.0;

/// The plunger near `at` that has a ball resting on it; null: none.
const Device* plunger_at(const Session& session, Vec2 at) {
    const double near = 3.0 * session.scene().world.balls().radius[0];
    if (!is_on_plunger(session.scene(), session.world())) return nullptr;
    for (const Device& device : session.scene().table.devices)
        if (device.kind == DeviceKind::plunger && std::abs(at.x - device.place.x) < near)
            return &device;
    return nullptr;
}

std::optional<Button> button_of_mouse(std::uint8_t mouse) {
    if (mouse == left_button) return Button::left_flipper;
    if (mouse == right_button) return Button::right_flipper;
    if (mouse == middle_button) return Button::plunger;
    return std::nullopt;
}

}  // namespace

std::optional<std::vector<command::Press>> PinballInput::take_mouse(const InputEvent& event,
                                                                    Vec2 at,
                                                                    const Session& session) {
    using enum InputEvent::Action;
    if (event.action == release && buttons_.has_mouse())
        return buttons_.release_mouse(event.button);
    if (event.action != press || event.modifiers != no_modifier) return std::nullopt;
    const Device* const plunger = event.button == left_button ? plunger_at(session, at) : nullptr;
    const std::optional<Button> button =
        plunger ? std::optional(Button::plunger) : button_of_mouse(event.button);
    if (!button || !has_button(session.scene(), *button)) return std::nullopt;
    if (plunger) grip_ = Grip{at, plunger->direction};
    return buttons_.press_mouse(event.button, *button);
}

std::optional<command::Pull> PinballInput::drag_plunger(const InputEvent& event, Vec2 at,
                                                        double row) {
    using enum InputEvent::Action;
    if (!grip_ || (event.action != move && event.action != release)) return std::nullopt;
    const double drawn = dot(grip_->from - at, grip_->direction) / (full_pull_rows * row);
    const double share = std::clamp(drawn, 0.0, 1.0);
    grip_->has_pulled = grip_->has_pulled || share > 0.0;
    if (event.action == move)
        return grip_->has_pulled ? std::optional(command::Pull{share, false}) : std::nullopt;
    const bool has_pulled = std::exchange(grip_, std::nullopt)->has_pulled;
    if (!has_pulled) return std::nullopt;
    buttons_.release_mouse(event.button);
    return command::Pull{share, true};
}

std::string PinballInput::next_flipper_mode() {
    buttons_.set_toggles(!buttons_.toggles());
    return buttons_.toggles() ? "a press raises a flipper, the next one lowers it"
                              : "flippers are up while they are held";
}

std::string PinballInput::flipper_mode() const {
    if (buttons_.toggles()) return "Each press turns one over.";
    if (buttons_.tells_release()) return "Hold to keep up.";
    return fmt::format("Hold to keep up (a tap lasts {:.2f} s).", buttons_.repeat().tap_length());
}

}  // namespace carom
