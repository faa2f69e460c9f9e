#include <fmt/format.h>

#include <utility>

#include "carom/play/player.h"
#include "game/pinball/pinball.h"

// A pinball table: its buttons, and what it says.
namespace carom {

const PinballState* Player::pinball() const {
    return std::get_if<PinballState>(&session_.game());
}

bool Player::handle_at_table(const InputEvent& event) {
    if (!table_ || is_watching() || page_ != Page::none) return false;
    if (event.kind != InputEvent::Kind::key) return false;
    if (table_->asks_initials()) {
        table_->type_initials(event);
        needs_draw_ = true;
        return true;
    }
    if (button_of(event)) {
        press_buttons(table_->take(event));
        return true;
    }
    if (event.action != InputEvent::Action::press || event.modifiers != no_modifier) return false;
    if (event.key == demo_key) {
        demonstrate(!table_->is_demonstrating());
        return true;
    }
    if (event.key == hold_key) {
        say(table_->next_hold());
        return true;
    }
    if (event.key == bell_key) {
        has_bell_ = !has_bell_;
        bell_is_due_ = has_bell_;
        say(has_bell_ ? "the terminal's bell rings for what kicks" : "no bell");
        return true;
    }
    return false;
}

bool Player::handle_table_mouse(const InputEvent& event) {
    if (!table_ || is_watching()) return false;
    const Vec2 at = to_world(camera_, {event.column, event.row});
    const double row = length(to_world(camera_, {0.0, 1.0}) - to_world(camera_, {0.0, 0.0}));
    if (const auto pull = table_->drag_plunger(event, at, row)) {
        session_.apply(*pull);
        needs_draw_ = true;
        return true;
    }
    const auto presses = table_->take_mouse(event, at, session_);
    if (!presses) return false;
    press_buttons(*presses);
    return true;
}

void Player::press_buttons(const std::vector<command::Press>& presses) {
    for (const command::Press& press : presses)
        if (has_button(session_.scene(), press.button)) session_.apply(press);
    if (!presses.empty()) needs_draw_ = true;
}

void Player::demonstrate(bool does) {
    if (!table_ || is_watching()) return;
    if (!does) press_buttons(table_->let_go());
    table_->demonstrate(does);
    say(does ? "carom plays: any key of the table takes over" : "your game");
}

void Player::play_demonstration() {
    if (table_ && table_->is_demonstrating() && session_.world().tick >= session_.latest())
        for (const command::Press& press : table_->play(session_))
            session_.apply(press);
}

void Player::set_high_scores(HighScores scores) {
    if (table_) table_->set_high_scores(std::move(scores));
    needs_draw_ = true;
}

std::optional<HighScore> Player::take_high_score() {
    return table_ ? table_->take_high_score() : std::nullopt;
}

void Player::set_key_release(bool tells) {
    key_release_ = tells;
    if (table_ && tells) table_->set_tells_release(true);
}

bool Player::take_bell() {
    return std::exchange(bell_is_due_, false);
}

// What the table says while time passes; a message stands until the next. Beside the table there is
// room for it, so that the keys stay in sight.
void Player::hear_table(double seconds) {
    if (!table_) return;
    if (table_->rings(session_, seconds) && has_bell_) bell_is_due_ = true;
    table_->watch_end(session_);
    const auto heard = table_->hear(session_);
    if (heard && !heard->empty() && !table_->has_panel()) say(*heard);
}

std::string Player::hold_line() const {
    if (!has_button(session_.scene(), Button::left_flipper) &&
        !has_button(session_.scene(), Button::right_flipper))
        return {};
    const std::string mouse = mouse_is_off_ ? "" : " or mouse buttons";
    return fmt::format("flippers z /{}: {} ({}: change)", mouse, table_->hold_text(),
                       static_cast<char>(hold_key));
}

std::string Player::score_line() const {
    const PinballState* state = pinball();
    if (!state || !session_.scene().table.is_game || table_->has_panel()) return {};
    std::string line = fmt::format("score {}, ball {} of {}", grouped(state->score), state->ball,
                                   session_.scene().table.balls);
    if (state->multiplier > 1) line += fmt::format(", bonus x{}", state->multiplier);
    if (state->is_tilted) line += ", tilt";
    if (state->phase == PinballState::Phase::over) line += ", game over";
    return line;
}

void Player::add_table_hints(std::vector<KeyHelp>& hints) const {
    const Scene& scene = session_.scene();
    if (table_->asks_initials()) {
        hints.push_back({"a-z 0-9", "your initials"});
        hints.push_back({"enter", "done"});
        hints.push_back({"esc", "none"});
        return;
    }
    if (has_button(scene, Button::left_flipper) || has_button(scene, Button::right_flipper)) {
        hints.push_back(help_of_flippers());
    }
    if (has_button(scene, Button::plunger)) hints.push_back(help_of_plunger());
    if (has_button(scene, Button::nudge_up)) hints.push_back(help_of_nudges());
    hints.push_back({std::string(1, static_cast<char>(demo_key)),
                     table_->is_demonstrating() ? "play yourself" : "watch carom play"});
}

}  // namespace carom
