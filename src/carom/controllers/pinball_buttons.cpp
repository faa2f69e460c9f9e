#include "carom/controllers/pinball_buttons.h"

#include <algorithm>
#include <utility>

namespace carom {
namespace {

// A terminal repeats a key after 0.25 to 0.6 s, then about 30 times a second.
constexpr double flipper_hold = 0.2;
constexpr double plunger_hold = 0.6;
constexpr double nudge_hold = 0.1;
constexpr double repeat_hold = 0.15;
constexpr double repeats_within = 0.12;

double first_hold(Button button) {
    switch (button) {
        case Button::left_flipper:
        case Button::right_flipper:
            return flipper_hold;
        case Button::plunger:
            return plunger_hold;
        default:
            return nudge_hold;
    }
}

}  // namespace

std::vector<command::Press> PinballButtons::take(Button button, const InputEvent& event) {
    Held& held = held_[static_cast<std::size_t>(button)];
    const bool is_toggled =
        toggles_ && (button == Button::left_flipper || button == Button::right_flipper);
    if (event.action == InputEvent::Action::release) {
        tells_release_ = true;
        if (is_toggled || !std::exchange(held.is_down, false)) return {};
        return {{button, false}};
    }
    const bool repeats = event.action == InputEvent::Action::repeat || held.since < repeats_within;
    held.since = 0.0;
    if (is_toggled) {
        if (repeats) return {};
        held.is_down = !held.is_down;
        return {{button, held.is_down}};
    }
    held.left = repeats ? std::max(held.left, repeat_hold) : first_hold(button);
    if (std::exchange(held.is_down, true)) return {};
    return {{button, true}};
}

std::vector<command::Press> PinballButtons::press_mouse(std::uint8_t mouse, Button button) {
    Held& held = held_[static_cast<std::size_t>(button)];
    held.mouse = mouse;
    if (std::exchange(held.is_down, true)) return {};
    return {{button, true}};
}

std::vector<command::Press> PinballButtons::release_mouse(std::uint8_t mouse) {
    std::vector<command::Press> released;
    for (std::size_t i = 0; i < held_.size(); ++i) {
        Held& held = held_[i];
        // Some terminals do not report which button was released; such a report counts for all.
        if (!held.mouse || (mouse != 0 && mouse != *held.mouse)) continue;
        held.mouse.reset();
        if (std::exchange(held.is_down, false)) released.push_back({static_cast<Button>(i), false});
    }
    return released;
}

bool PinballButtons::has_mouse() const {
    return std::ranges::any_of(held_, [](const Held& held) { return held.mouse.has_value(); });
}

std::vector<command::Press> PinballButtons::pass(double seconds) {
    std::vector<command::Press> released;
    for (std::size_t i = 0; i < held_.size(); ++i) {
        Held& held = held_[i];
        const bool is_flipper = i <= static_cast<std::size_t>(Button::right_flipper);
        held.since += seconds;
        held.left -= seconds;
        const bool stays = tells_release_ || held.mouse || (toggles_ && is_flipper);
        if (!held.is_down || held.left > 0.0 || stays) continue;
        held.is_down = false;
        released.push_back({static_cast<Button>(i), false});
    }
    return released;
}

std::vector<command::Press> PinballButtons::release_all() {
    std::vector<command::Press> released;
    for (std::size_t i = 0; i < held_.size(); ++i)
        if (std::exchange(held_[i].is_down, false))
            released.push_back({static_cast<Button>(i), false});
    return released;
}

bool PinballButtons::is_down() const {
    return std::ranges::any_of(held_, &Held::is_down);
}

}  // namespace carom
