#include "carom/play/player.h"

#include <limits>
#include <utility>

#include "carom/context/page_keys.h"
#include "carom/context/time_control.h"
#include "carom/context/view_control.h"
#include "carom/controllers/make_controller.h"
#include "carom/controllers/pinball_controller.h"
#include "carom/controllers/pool_controller.h"
#include "carom/controllers/watch_controller.h"

namespace carom {
namespace {

/// Zoom factor for one step of the wheel.
constexpr double wheel_factor = 1.15;

// The key of another page opens that page; any other key that does not scroll closes this one. A
// page that is visible as a whole does not scroll.
void turn_page(PlayContext& play, const InputEvent& event, const Action* action) {
    play.needs_draw = true;
    if (const auto rows = scroll_of(event); rows && play.page.most > 0) {
        play.page.scroll += *rows;
        return;
    }
    const CoveringPage::Kind before = std::exchange(play.page, {}).kind;
    if (!action || (action->name != "help" && action->name != "about")) return;
    play.controller->perform(play, *action);
    if (play.page.kind == before) play.page = {};
}

void handle_mouse(PlayContext& play, const InputEvent& event) {
    using enum InputEvent::Action;
    if (play.page.is_open()) {
        if (event.action == press) play.page = {};
        if (event.action == wheel_down) ++play.page.scroll;
        if (event.action == wheel_up) --play.page.scroll;
        play.needs_draw = true;
        return;
    }
    if (play.controller->take(play, event)) return;
    Pointer& pointer = play.pointer;
    const CellPoint place = play.companion.in_first_half({event.column, event.row});
    if (pointer.panning_from && event.action == move) {
        play.view.pan(pointer.panning_from->column - place.column,
                      pointer.panning_from->row - place.row);
        pointer.panning_from = place;
        play.needs_draw = true;
        return;
    }
    if (event.action == wheel_up || event.action == wheel_down) {
        play.view.zoom(place, event.action == wheel_up ? wheel_factor : 1.0 / wheel_factor);
        play.needs_draw = true;
        return;
    }
    pointer.shows_cursor = false;
    move_pointer(play, to_world(play.view.camera, place));
    if (event.action == press) {
        play.needs_draw = true;
        play.messages.end_message();
        play.controller->press(play, event);
    } else if (event.action == release) {
        play.needs_draw = true;
        play.messages.end_message();
        if (std::exchange(pointer.panning_from, {})) tell_way_back(play);
        play.controller->release(play, event);
    }
}

}  // namespace

Player::Player(Session session, const ViewOptions& view, KeyMap keys, bool solver_is_picked)
    : play_(std::move(session), view, std::move(keys), solver_is_picked) {
    play_.controller = make_controller(play_.session);
    set_view(view);
    play_.view.defaults = play_.view.options;
}

Player Player::continued_with(Session session, bool solver_is_picked) const {
    Player next(std::move(session), view(), play_.keys, solver_is_picked);
    PlayContext& play = next.play_;
    play.clock = play_.clock;
    next.set_keep_going(play_.keep_going);
    play.terminal = play_.terminal;
    play.controller->continue_from(play, *play_.controller);
    play.pointer.shows_cursor = play_.pointer.shows_cursor;
    play.view.shows_whole = play_.view.shows_whole;
    if (play.session.scene().view == play_.session.scene().view) {
        play.view.camera = play_.view.camera;
        play.view.is_fitted = play_.view.is_fitted;
        play.pointer.at = play_.pointer.at;
    }
    return next;
}

PlayRequest Player::handle(const InputEvent& event) {
    if (event.kind == InputEvent::Kind::mouse) {
        handle_mouse(play_, event);
        return PlayRequest::none;
    }
    if (!play_.page.is_open() && play_.controller->take(play_, event)) return PlayRequest::none;
    if (event.kind != InputEvent::Kind::key || event.action == InputEvent::Action::release)
        return PlayRequest::none;
    const Action* const action = play_.keys.action_of(key_of(event));
    if (play_.page.is_open()) {
        turn_page(play_, event, action);
        // These leave the page, on which they are explained.
        const bool is_setting = action && (action->name == "theme" || action->name == "change-key");
        return is_setting ? perform(*action) : PlayRequest::none;
    }
    return action ? perform(*action) : PlayRequest::none;
}

PlayRequest Player::perform(const Action& action) {
    play_.needs_draw = true;
    play_.messages.end_message();
    play_.controller->perform(play_, action);
    keep_up(play_, [] { return false; });
    return std::exchange(play_.request, PlayRequest::none);
}

void Player::fade_messages(double seconds) {
    if (play_.page.is_open()) return;
    if (play_.messages.fade(seconds)) play_.needs_draw = true;
}

void Player::advance(double seconds, const MayGoOn& may_go_on) {
    if (is_too_small_ || play_.page.is_open()) return;
    play_.controller->pass(play_, seconds);
    advance_time(play_, seconds, may_go_on);
}

double Player::seconds_to_change() const {
    const bool is_waiting = is_idle(play_) && !play_.companion.is_behind(play_.session) &&
                            !play_.controller->has_work();
    if (!is_waiting && !is_too_small_ && !play_.page.is_open()) return 0.0;
    return play_.messages.seconds_left().value_or(std::numeric_limits<double>::infinity());
}

bool Player::wants_motion() const {
    return !play_.pointer.pressed &&
           (play_.pointer.tool.has_cue() || play_.pointer.tool.has_new_edge());
}

void Player::say(std::string message) {
    carom::say(play_, std::move(message));
}

void Player::complain(std::string message) {
    carom::complain(play_, std::move(message));
}

void Player::set_problem(std::vector<std::string> lines) {
    play_.messages.set_problem(std::move(lines));
    play_.needs_draw = true;
}

void Player::set_prompt(std::string prompt) {
    play_.messages.set_prompt(std::move(prompt));
    play_.needs_draw = true;
}

void Player::pause(bool paused) {
    play_.clock.pause(paused);
    play_.needs_draw = true;
}

void Player::set_keep_going(const KeepGoing& keep_going) {
    play_.keep_going = keep_going;
    play_.session.set_keep_going(keep_going);
}

void Player::set_view(const ViewOptions& view) {
    play_.view.options = view;
    play_.view.options.is_table = !play_.session.scene().table.is_empty();
    play_.needs_draw = true;
}

void Player::set_keys(const KeyMap& keys) {
    play_.keys = keys;
    play_.needs_draw = true;
}

bool Player::take_bell() {
    return std::exchange(play_.terminal.bell_is_due, false);
}

void Player::set_high_scores(HighScores scores) {
    play_.controller->set_high_scores(std::move(scores));
    play_.needs_draw = true;
}

PoolPlayers* Player::pool_players() {
    auto* const pool = dynamic_cast<PoolController*>(play_.controller.get());
    return pool ? &pool->players() : nullptr;
}

const PoolPlayers* Player::pool_players() const {
    const auto* const pool = dynamic_cast<const PoolController*>(play_.controller.get());
    return pool ? &pool->players() : nullptr;
}

PinballScores* Player::pinball_scores() {
    auto* const pinball = dynamic_cast<PinballController*>(play_.controller.get());
    return pinball ? &pinball->scores() : nullptr;
}

const PinballScores* Player::pinball_scores() const {
    const auto* const pinball = dynamic_cast<const PinballController*>(play_.controller.get());
    return pinball ? &pinball->scores() : nullptr;
}

void Player::watch_opponent(int number) {
    dynamic_cast<WatchController&>(*play_.controller).set_opponent(number);
}

std::optional<ShotSetup> Player::shot_setup() const {
    const auto* const pool = dynamic_cast<const PoolController*>(play_.controller.get());
    return pool ? std::optional(pool->aim().setup()) : std::nullopt;
}

void Player::set_up(const ShotSetup& setup) {
    auto* const pool = dynamic_cast<PoolController*>(play_.controller.get());
    if (pool) pool->aim().set_up(play_.session, setup);
}

void Player::demonstrate() {
    auto* const pinball = dynamic_cast<PinballController*>(play_.controller.get());
    if (pinball) pinball->demonstrate(play_, true);
}

bool Player::is_demonstrating() const {
    const auto* const pinball = dynamic_cast<const PinballController*>(play_.controller.get());
    return pinball && pinball->is_demonstrating();
}

int opponent_of(const Player& player) {
    const PoolPlayers* const players = player.pool_players();
    return players ? players->opponent() : 0;
}

bool cancels_tick(const InputEvent& event, const KeyMap& keys) {
    using enum InputEvent::Action;
    switch (event.kind) {
        case InputEvent::Kind::mouse:
            return event.action == press || event.action == release;
        case InputEvent::Kind::key:
            return keys.button_of(key_of(event)) ||
                   (event.action != release && keys.action_of(key_of(event)));
        default:
            return true;
    }
}

}  // namespace carom
