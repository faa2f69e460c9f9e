#include "carom/controllers/table_keys.h"

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

std::optional<Button> button_of(const InputEvent& event) {
    if (event.kind != InputEvent::Kind::key || event.modifiers != no_modifier) return std::nullopt;
    switch (event.key) {
        case U'z':
        case key::left:
            return Button::left_flipper;
        case U'/':
        case key::right:
            return Button::right_flipper;
        case key::enter:
        case key::down:
            return Button::plunger;
        case U'x':
            return Button::nudge_left;
        case U'.':
            return Button::nudge_right;
        case key::up:
            return Button::nudge_up;
        default:
            return std::nullopt;
    }
}

KeyHelp help_of_flippers() {
    return {"z /", "flippers"};
}
KeyHelp help_of_plunger() {
    return {"enter", "hold: plunger"};
}
KeyHelp help_of_nudges() {
    return {"x up .", "nudge"};
}

std::vector<command::Press> TableKeys::take(const InputEvent& event) {
    const auto button = button_of(event);
    if (!button) return {};
    Held& held = held_[static_cast<std::size_t>(*button)];
    const bool is_toggled =
        toggles_ && (*button == Button::left_flipper || *button == Button::right_flipper);
    if (event.action == InputEvent::Action::release) {
        tells_release_ = true;
        if (is_toggled || !std::exchange(held.is_down, false)) return {};
        return {{*button, false}};
    }
    const bool repeats = event.action == InputEvent::Action::repeat || held.since < repeats_within;
    held.since = 0.0;
    if (is_toggled) {
        if (repeats) return {};
        held.is_down = !held.is_down;
        return {{*button, held.is_down}};
    }
    held.left = repeats ? std::max(held.left, repeat_hold) : first_hold(*button);
    if (std::exchange(held.is_down, true)) return {};
    return {{*button, true}};
}

std::vector<command::Press> TableKeys::press_mouse(std::uint8_t mouse, Button button) {
    Held& held = held_[static_cast<std::size_t>(button)];
    held.mouse = mouse;
    if (std::exchange(held.is_down, true)) return {};
    return {{button, true}};
}

std::vector<command::Press> TableKeys::release_mouse(std::uint8_t mouse) {
    std::vector<command::Press> released;
    for (std::size_t i = 0; i < held_.size(); ++i) {
        Held& held = held_[i];
        // Some terminals do not say which button was let go.
        if (!held.mouse || (mouse != 0 && mouse != *held.mouse)) continue;
        held.mouse.reset();
        if (std::exchange(held.is_down, false)) released.push_back({static_cast<Button>(i), false});
    }
    return released;
}

bool TableKeys::has_mouse() const {
    return std::ranges::any_of(held_, [](const Held& held) { return held.mouse.has_value(); });
}

std::vector<command::Press> TableKeys::pass(double seconds) {
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

std::vector<command::Press> TableKeys::let_go() {
    std::vector<command::Press> released;
    for (std::size_t i = 0; i < held_.size(); ++i)
        if (std::exchange(held_[i].is_down, false))
            released.push_back({static_cast<Button>(i), false});
    return released;
}

bool TableKeys::is_down() const {
    return std::ranges::any_of(held_, &Held::is_down);
}

}  // namespace carom
