#include "carom/table_seat.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "game/pinball.h"

namespace carom {
namespace {

constexpr std::uint8_t left_button = 1;
constexpr std::uint8_t middle_button = 2;
constexpr std::uint8_t right_button = 3;

const PinballState& state_of(const Session& session) {
    return std::get<PinballState>(session.game());
}

/// The plunger on which a ball lies, near this place.
bool is_at_plunger(const Session& session, Vec2 at) {
    const double near = 3.0 * session.scene().world.balls.radius[0];
    return is_on_plunger(session.scene(), session.world()) &&
           std::ranges::any_of(session.scene().table.devices, [&](const Device& device) {
               return device.kind == DeviceKind::plunger && std::abs(at.x - device.place.x) < near;
           });
}

}  // namespace

bool TableSeat::is_at(const Session& session) {
    return std::holds_alternative<PinballState>(session.game());
}

std::vector<command::Press> TableSeat::take(const InputEvent& event) {
    demonstrate(false);
    return keys_.take(event);
}

std::optional<std::vector<command::Press>> TableSeat::take_mouse(const InputEvent& event, Vec2 at,
                                                                 const Session& session) {
    using enum InputEvent::Action;
    if (event.action == release && keys_.has_mouse()) return keys_.release_mouse(event.button);
    if (event.action != press || event.modifiers != no_modifier) return std::nullopt;
    std::optional<Button> button;
    if (event.button == left_button) button = Button::left_flipper;
    if (event.button == right_button) button = Button::right_flipper;
    if (event.button == middle_button) button = Button::plunger;
    if (event.button == left_button && is_at_plunger(session, at)) button = Button::plunger;
    if (!button || !has_button(session.scene(), *button)) return std::nullopt;
    demonstrate(false);
    return keys_.press_mouse(event.button, *button);
}

std::string TableSeat::next_hold() {
    keys_.set_toggles(!keys_.toggles());
    return keys_.toggles() ? "a press raises a flipper, the next one lowers it"
                           : "flippers are up while they are held";
}

std::string TableSeat::hold_text() const {
    if (keys_.toggles()) return "each press turns one over";
    return keys_.tells_release() ? "up while held" : "up 0.2 s, on while the key repeats";
}

std::vector<command::Press> TableSeat::play(const Session& session) {
    if (!demo_) return {};
    return demo_->play(session.scene(), session.world(), state_of(session));
}

std::optional<std::string> TableSeat::hear(const Session& session) {
    const std::string& message = state_of(session).message;
    if (message == heard_) return std::nullopt;
    heard_ = message;
    return heard_;
}

// The letters are asked for once a game, and not for what carom has played.
void TableSeat::watch_end(const Session& session) {
    const PinballState& state = state_of(session);
    was_demonstrated_ = was_demonstrated_ || is_demonstrating();
    if (state.phase != PinballState::Phase::over) {
        if (state.games != last_game_ && state.score == 0) was_demonstrated_ = is_demonstrating();
        return;
    }
    if (state.games == last_game_ || session.is_following()) return;
    last_game_ = state.games;
    if (was_demonstrated_ || !honours_.takes(state.score)) return;
    initials_ = "";
    asked_for_ = state.score;
}

void TableSeat::type_initials(const InputEvent& event) {
    if (!initials_ || event.action == InputEvent::Action::release) return;
    if (event.key == key::backspace) {
        if (!initials_->empty()) initials_->pop_back();
        return;
    }
    if (event.key == key::escape) {
        initials_.reset();
        return;
    }
    const bool is_letter = (event.key >= U'a' && event.key <= U'z') ||
                           (event.key >= U'A' && event.key <= U'Z') ||
                           (event.key >= U'0' && event.key <= U'9');
    if (is_letter && initials_->size() < 3) {
        char letter = static_cast<char>(event.key);
        if (letter >= 'a') letter = static_cast<char>(letter - 'a' + 'A');
        initials_->push_back(letter);
    }
    if (event.key != key::enter || initials_->empty()) return;
    initials_->resize(3, '-');
    written_ = newest_ = Honour{*initials_, asked_for_};
    initials_.reset();
}

std::optional<Honour> TableSeat::take_honour() {
    return std::exchange(written_, std::nullopt);
}

}  // namespace carom
