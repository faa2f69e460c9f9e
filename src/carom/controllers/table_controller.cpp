#include "carom/controllers/table_controller.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "game/pinball/pinball.h"

namespace carom {
namespace {

constexpr std::uint8_t left_button = 1;
constexpr std::uint8_t middle_button = 2;
constexpr std::uint8_t right_button = 3;

constexpr double full_pull_rows = 6.0;  // of the screen, over which the plunger is drawn back
constexpr double bell_pause = 0.12;     // s between two bells at least

const PinballState& state_of(const Session& session) {
    return std::get<PinballState>(session.game());
}

/// The plunger on which a ball lies, near this place.
const Device* plunger_at(const Session& session, Vec2 at) {
    const double near = 3.0 * session.scene().world.balls.radius[0];
    if (!is_on_plunger(session.scene(), session.world())) return nullptr;
    for (const Device& device : session.scene().table.devices)
        if (device.kind == DeviceKind::plunger && std::abs(at.x - device.place.x) < near)
            return &device;
    return nullptr;
}

/// When the last of what kicks will have shone, in ticks.
std::uint64_t last_flash(const PinballState& state) {
    std::uint64_t last = 0;
    for (const std::uint64_t until : state.flash_until)
        last = std::max(last, until);
    return last;
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
    const Device* const plunger = event.button == left_button ? plunger_at(session, at) : nullptr;
    if (plunger) button = Button::plunger;
    if (!button || !has_button(session.scene(), *button)) return std::nullopt;
    demonstrate(false);
    if (plunger) grip_ = Grip{at, plunger->direction};
    return keys_.press_mouse(event.button, *button);
}

std::optional<command::Pull> TableSeat::drag_plunger(const InputEvent& event, Vec2 at, double row) {
    using enum InputEvent::Action;
    if (!grip_ || (event.action != move && event.action != release)) return std::nullopt;
    const double drawn = dot(grip_->from - at, grip_->direction) / (full_pull_rows * row);
    const double share = std::clamp(drawn, 0.0, 1.0);
    grip_->has_pulled = grip_->has_pulled || share > 0.0;
    if (event.action == move)
        return grip_->has_pulled ? std::optional(command::Pull{share, false}) : std::nullopt;
    const bool has_pulled = std::exchange(grip_, std::nullopt)->has_pulled;
    if (!has_pulled) return std::nullopt;
    keys_.release_mouse(event.button);
    return command::Pull{share, true};
}

bool TableSeat::rings(const Session& session, double seconds) {
    since_bell_ += seconds;
    const PinballState& state = state_of(session);
    const std::uint64_t flash = last_flash(state);
    const bool is_new = flash > heard_flash_ || state.held.size() > heard_held_;
    heard_flash_ = flash;  // less than before after a step back
    heard_held_ = state.held.size();
    if (!is_new || since_bell_ < bell_pause) return false;
    since_bell_ = 0.0;
    return true;
}

void TableSeat::continue_from(const TableSeat& before, std::size_t most_scores) {
    keys_ = before.keys_;
    keys_.let_go();
    shows_whole_ = before.shows_whole_;
    newest_ = before.newest_;
    high_scores_ = before.high_scores_;
    high_scores_.most = most_scores;
    high_scores_.lines.resize(std::min(high_scores_.lines.size(), most_scores));
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
    if (was_demonstrated_ || !high_scores_.takes(state.score)) return;
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
    written_ = newest_ = HighScore{*initials_, asked_for_};
    initials_.reset();
}

std::optional<HighScore> TableSeat::take_high_score() {
    return std::exchange(written_, std::nullopt);
}

}  // namespace carom
