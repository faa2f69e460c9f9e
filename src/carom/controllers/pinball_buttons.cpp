#include "carom/controllers/pinball_buttons.h"

#include <algorithm>
#include <utility>

namespace carom {
namespace {

// How long a flipper drops that is pressed again while it is up, s: it falls by about a third.
constexpr double drop_time = 0.05;

bool is_flipper(Button button) {
    return button == Button::left_flipper || button == Button::right_flipper;
}

}  // namespace

std::vector<command::Press> PinballButtons::take(Button button, const InputEvent& event) {
    using enum InputEvent::Action;
    Held& held = held_[static_cast<std::size_t>(button)];
    const bool is_toggled = toggles_ && is_flipper(button);
    if (event.action == release) {
        tells_release_ = true;
        if (is_toggled || !std::exchange(held.is_down, false)) return {};
        return {{button, false}};
    }
    const double time = now_ + event.after;
    const bool repeats = tells_release_
                             ? event.action == repeat
                             : repeat_.take(event.key, time) == KeyRepeat::Meaning::repeat;
    if (is_toggled) {
        if (repeats) return {};
        held.is_down = !held.is_down;
        return {{button, held.is_down}};
    }
    const bool is_taken_over = std::exchange(held.outlasts_pause, false);
    note_repeat(repeats, held);
    if (held.is_down) {
        if (repeats || tells_release_ || is_taken_over) return {};
        return press_again(button, held, time);
    }
    // A repeat that comes later than it should raises a flipper again, and pulls no plunger.
    if (held.rises_at || (repeats && !is_flipper(button))) return {};
    held.is_down = true;
    return {{button, true}};
}

// The key pressed last repeats for all that are held.
void PinballButtons::note_repeat(bool repeats, Held& held) {
    if (!repeats) held.has_repeated = false;
    for (Held& each : held_)
        if (repeats) each.has_repeated = each.is_down;
}

std::vector<command::Press> PinballButtons::press_again(Button button, Held& held,
                                                        double time) const {
    if (held.mouse) return {};
    if (button == Button::plunger) {
        held.is_down = false;
        return {{button, false}};
    }
    if (!is_flipper(button)) return {{button, false}, {button, true}};
    held.is_down = false;
    held.rises_at = time + drop_time;
    return {{button, false}};
}

void PinballButtons::take_other_key(const InputEvent& event) {
    if (event.action == InputEvent::Action::release || tells_release_) return;
    repeat_.take(event.key, now_ + event.after);
}

std::vector<command::Press> PinballButtons::press_mouse(std::uint8_t mouse, Button button) {
    Held& held = held_[static_cast<std::size_t>(button)];
    held.mouse = mouse;
    held.rises_at.reset();
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

std::vector<command::Press> PinballButtons::pass(double seconds, bool is_paused) {
    now_ += seconds;
    std::vector<command::Press> changes;
    for (std::size_t i = 0; i < held_.size(); ++i) {
        Held& held = held_[i];
        const auto button = static_cast<Button>(i);
        if (held.rises_at && now_ >= *held.rises_at) {
            held.rises_at.reset();
            held.is_down = true;
            changes.push_back({button, true});
        }
        if (is_paused && held.is_down && held.has_repeated) held.outlasts_pause = true;
        const bool stays =
            tells_release_ || held.mouse || held.outlasts_pause || (toggles_ && is_flipper(button));
        if (!held.is_down || stays || now_ < repeat_.may_be_held_until()) continue;
        held.is_down = false;
        changes.push_back({button, false});
    }
    return changes;
}

std::vector<command::Press> PinballButtons::let_go(Button button) {
    Held& held = held_[static_cast<std::size_t>(button)];
    held.outlasts_pause = false;
    if (!std::exchange(held.is_down, false)) return {};
    return {{button, false}};
}

std::vector<command::Press> PinballButtons::release_all() {
    std::vector<command::Press> released;
    for (std::size_t i = 0; i < held_.size(); ++i) {
        held_[i].rises_at.reset();
        held_[i].outlasts_pause = false;
        if (std::exchange(held_[i].is_down, false))
            released.push_back({static_cast<Button>(i), false});
    }
    return released;
}

bool PinballButtons::is_down() const {
    return std::ranges::any_of(held_, &Held::is_down);
}

}  // namespace carom
