#include <fmt/format.h>

#include <utility>

#include "carom/play/player.h"
#include "game/pool/pool_words.h"

/// A pool table: the aim by keys and by mouse, the ball in hand, choices, and what the referee
/// says.
namespace carom {
namespace {

// By one key.
constexpr double coarse = 1.0;  // degrees
constexpr double fine = 0.05;
constexpr double speed_step = 0.1;  // m/s
constexpr double tip_step = 0.05;   // of the radius

constexpr double last_seconds = 5.0;  // of the clock, that are told loudly

constexpr std::uint8_t left_button = 1;
constexpr std::uint8_t middle_button = 2;

}  // namespace

const PoolPlay* Player::pool() const {
    return std::get_if<PoolPlay>(&session_.game());
}

PlayerNames Player::names() const {
    if (opponent_) return {"you", "carom"};
    return {"player 1", "player 2"};
}

bool Player::is_aiming() const {
    return seat_ && page_ == Page::none && !is_opponents_turn() && seat_->may_aim(session_);
}

void Player::aim_by_key(double degrees, double speed) {
    seat_->turn(degrees);
    seat_->change_speed(speed);
    needs_draw_ = true;
}

// While there is something to aim, the keys that look elsewhere move the tip.
bool Player::move_tip(Action action) {
    if (!is_aiming() || shows_cursor_) return false;
    switch (action) {
        case Action::pan_left:
            seat_->move_tip(-tip_step, 0.0);
            return true;
        case Action::pan_right:
            seat_->move_tip(tip_step, 0.0);
            return true;
        case Action::pan_up:
            seat_->move_tip(0.0, tip_step);
            return true;
        case Action::pan_down:
            seat_->move_tip(0.0, -tip_step);
            return true;
        default:
            return false;
    }
}

bool Player::perform_at_pool(Action action) {
    if (!seat_) {
        if (action < Action::aim_left || action > Action::coach) return false;
        say("that is for pool tables");
        return true;
    }
    const bool aims = is_aiming() && tool_.is_empty() && !shows_cursor_;
    switch (action) {
        case Action::cursor_left:
        case Action::cursor_right:
            if (aims) seat_->turn(action == Action::cursor_left ? coarse : -coarse);
            return aims;
        case Action::cursor_up:
        case Action::cursor_down:
            if (aims) seat_->change_speed(action == Action::cursor_up ? speed_step : -speed_step);
            return aims;
        case Action::aim_left:
        case Action::aim_right:
            if (!tool_.is_empty())
                move_cursor(action == Action::aim_left ? -0.2 : 0.2, 0.0);
            else
                seat_->turn(action == Action::aim_left ? fine : -fine);
            return true;
        case Action::grab:
            if (aims) shoot();
            return aims;
        case Action::cue:
            if (aims) say("the arrows aim, enter shoots; or drag with the right button");
            return aims;
        case Action::next_pot:
        case Action::previous_pot:
            if (is_aiming()) say(seat_->next_pot(session_, action == Action::previous_pot));
            return true;
        case Action::call:
            say(seat_->next_call(session_));
            return true;
        case Action::aids:
            say(seat_->next_aids());
            return true;
        case Action::place_cue_ball:
            place_cue_ball();
            return true;
        case Action::opponent:
            next_opponent();
            return true;
        case Action::coach:
            ask_coach();
            return true;
        case Action::next_frame:
            obey(command::RackAgain{}, "the balls are racked");
            return true;
        default:
            return false;
    }
}

void Player::shoot() {
    for (const Command& command : seat_->shot(session_))
        if (const auto why_not = session_.apply(command)) return complain(*why_not);
    set_reference();
}

void Player::place_cue_ball() {
    if (!tool_.is_empty()) {
        shows_cursor_ = false;
        return tool_.cancel(session_);
    }
    if (!is_aiming() || !seat_->may_place(session_)) return say("the ball is not in hand");
    const BallId ball = *seat_->cue_ball(session_);
    pointer_ = session_.world().balls.position[*index_of(session_.world(), ball)];
    tool_.take_to_place(session_.world(), ball, pointer_);
    shows_cursor_ = true;
    say("move the ball with the arrows; p or enter puts it down");
}

// 1, 2, 3: what the rules let the player choose from.
bool Player::choose(const InputEvent& event) {
    if (!pool() || !seat_ || page_ != Page::none || event.kind != InputEvent::Kind::key ||
        event.action == InputEvent::Action::release || event.modifiers != no_modifier)
        return false;
    const std::vector<PoolChoice>& choices = pool()->rules.choices;
    if (pool()->rules.phase != PoolPhase::choosing || is_opponents_turn() || event.key < U'1' ||
        event.key >= U'1' + choices.size())
        return false;
    const PoolChoice choice = choices[event.key - U'1'];
    obey(command::Decide{choice}, std::string(choice_text(choice)));
    return true;
}

bool Player::press_at_pool(const InputEvent& event) {
    if (!seat_ || event.button == middle_button) return false;
    const auto cue = seat_->cue_ball(session_);
    const auto at_pointer = ball_at_pointer();
    const bool is_left = event.button == left_button && !(event.modifiers & (shift | control));
    if (is_left && at_pointer && !pool()) return false;
    if (is_left && at_pointer && at_pointer == cue && is_aiming() && seat_->may_place(session_)) {
        tool_.take_to_place(session_.world(), *cue, pointer_);
        pressed_ = event.button;
        return true;
    }
    if (!is_aiming()) {
        if (is_opponents_turn()) say("it is carom's turn");
        const auto why_not = pool() && cue ? refusal_to_shoot(*pool(), *cue) : std::nullopt;
        if (why_not) say(*why_not);
        return pool() != nullptr || !is_left;
    }
    pressed_ = event.button;
    if (is_left) {
        if (seat_->call_pocket(session_, pointer_)) return true;
        aims_by_mouse_ = true;
        seat_->aim_at(session_, pointer_);
    } else {
        cue_is_armed_ = false;
        tool_.take_cue(*cue, pointer_);
    }
    return true;
}

bool Player::release_at_pool() {
    if (!seat_) return false;
    if (std::exchange(aims_by_mouse_, false)) return true;
    if (!tool_.has_cue()) return false;
    tool_.forget();
    // A click that pulls nothing shoots nothing.
    const auto cue = seat_->cue_ball(session_);
    const double radius =
        cue ? session_.world().balls.radius[*index_of(session_.world(), *cue)] : 0.0;
    const bool is_pulled =
        cue &&
        distance(pointer_, session_.world().balls.position[*index_of(session_.world(), *cue)]) >
            1.5 * radius;
    if (is_pulled && is_aiming()) shoot();
    return true;
}

void Player::hear_referee() {
    if (!pool()) return;
    const std::string now = outcome_text(*pool(), names());
    if (now == heard_) return;
    heard_ = now;
    if (!heard_.empty()) say(heard_);
}

std::string Player::pool_title() const {
    const std::string clock = clock_text(session_.world(), *pool());
    return turn_text(*pool(), names()) + (clock.empty() ? "" : ", " + clock);
}

// What the person aims at, or carom; what was called, while the balls roll; what came of it.
std::string Player::pool_line() const {
    if (is_aiming()) return seat_->line(session_, view_.look);
    if (!pool() || is_watching()) return "";
    if (is_opponents_turn()) return opponent_says_.empty() ? "carom thinks" : opponent_says_;
    if (!pool()->is_shooting) return outcome_text(*pool(), names());
    const std::string called = call_text(session_.scene(), pool()->call);
    return called.empty() ? "" : "called: " + called;
}

// The last seconds of who is to shoot, or to choose.
std::optional<std::string> Player::clock_warning() const {
    const auto left = pool() ? time_left(session_.world(), *pool()) : std::nullopt;
    const bool is_late = left && static_cast<double>(*left) <= last_seconds * session_.world().rate;
    if (!is_late || is_opponents_turn() || is_watching()) return std::nullopt;
    return fmt::format("{} left", clock_text(session_.world(), *pool()));
}

std::optional<PoolStance> Player::stance() const {
    return seat_ ? std::optional(seat_->stance()) : std::nullopt;
}

void Player::stand(const PoolStance& stance) {
    if (seat_) seat_->stand(session_, stance);
}

bool Player::is_in_match() const {
    if (!pool() || is_watching() || match_winner(*pool())) return false;
    return pool()->shooter || pool()->frames != std::array<std::uint32_t, 2>{};
}

std::vector<KeyHelp> Player::pool_hints() const {
    std::vector<KeyHelp> hints;
    const auto hint = [&](Action action, std::string_view what) {
        const std::string keys = keys_.hint(action);
        if (!keys.empty()) hints.push_back({keys, std::string(what)});
    };
    if (pool() && pool()->rules.phase == PoolPhase::choosing && !is_opponents_turn()) {
        int key = 0;
        for (const PoolChoice choice : pool()->rules.choices)
            hints.push_back({fmt::format("{}", ++key), std::string(choice_text(choice))});
        return hints;
    }
    if (pool() && pool()->rules.phase == PoolPhase::over)
        hint(Action::next_frame, match_winner(*pool()) ? "the next match" : "the next frame");
    if (!is_aiming()) return hints;
    hint(Action::grab, "shoot");
    hints.push_back({"arrows", "aim, power"});
    hints.push_back({"shift-arrows", "tip"});
    if (seat_->may_place(session_)) hint(Action::place_cue_ball, "place the ball");
    hint(Action::next_pot, "next pot");
    hint(Action::aids, "lines");
    if (pool()) hint(Action::coach, "coach");
    if (pool() && !opponent_) hint(Action::opponent, "opponent");
    return hints;
}

}  // namespace carom
