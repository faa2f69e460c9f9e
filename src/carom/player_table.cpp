#include <fmt/format.h>

#include "carom/player.h"
#include "game/pinball.h"

// A pinball table: its buttons, and what it says.
namespace carom {
namespace {

/// 1234567 as 1,234,567.
std::string grouped(std::int64_t number) {
    std::string digits = fmt::format("{}", number);
    for (auto at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), ",");
    return digits;
}

}  // namespace

const PinballState* Player::pinball() const {
    return std::get_if<PinballState>(&session_.game());
}

bool Player::handle_button(const InputEvent& event) {
    if (!pinball() || is_watching() || page_ != Page::none || !button_of(event)) return false;
    press_buttons(table_keys_.take(event));
    return true;
}

void Player::press_buttons(const std::vector<command::Press>& presses) {
    for (const command::Press& press : presses)
        if (has_button(session_.scene(), press.button)) session_.apply(press);
    if (!presses.empty()) needs_draw_ = true;
}

// What the table says while time passes; a message stands until the next.
void Player::hear_table() {
    const PinballState* state = pinball();
    if (!state || state->message == heard_) return;
    heard_ = state->message;
    if (!heard_.empty()) say(heard_);
}

std::string Player::score_line() const {
    const PinballState* state = pinball();
    if (!state || !session_.scene().table.is_game) return {};
    std::string line = fmt::format("score {}, ball {} of {}", grouped(state->score), state->ball,
                                   session_.scene().table.balls);
    if (state->multiplier > 1) line += fmt::format(", bonus x{}", state->multiplier);
    if (state->is_tilted) line += ", tilt";
    if (state->phase == PinballState::Phase::over) line += ", game over";
    return line;
}

void Player::add_table_hints(std::vector<KeyHelp>& hints) const {
    const Scene& scene = session_.scene();
    if (has_button(scene, Button::left_flipper) || has_button(scene, Button::right_flipper))
        hints.push_back(help_of_flippers());
    if (has_button(scene, Button::plunger)) hints.push_back(help_of_plunger());
    if (has_button(scene, Button::nudge_up)) hints.push_back(help_of_nudges());
}

}  // namespace carom
