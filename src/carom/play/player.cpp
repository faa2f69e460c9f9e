#include "carom/play/player.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "physics/tick/totals.h"
#include "terminal/panels/pages.h"

namespace carom {
namespace {

/// How long a message stands, s.
constexpr double message_time = 4.0;

}  // namespace

Player::Player(Session session, const ViewOptions& view, KeyMap keys, bool solver_is_picked)
    : session_(std::move(session)),
      keys_(std::move(keys)),
      view_(view),
      solver_is_picked_(solver_is_picked),
      pointer_(center(session_.scene().view)) {
    for (const Show& show : session_.scene().shows) {
        shows_histogram_ = shows_histogram_ || show.what == Show::What::histogram;
        shows_energy_ = shows_energy_ || show.what == Show::What::energy;
    }
    if (PoolAim::is_at(session_.scene()) && !session_.is_following()) seat_.emplace(session_);
    if (TableSeat::is_at(session_)) table_.emplace();
    set_reference();
}

Player Player::continued_with(Session session, bool solver_is_picked) const {
    Player next(std::move(session), view_, keys_, solver_is_picked);
    next.clock_ = clock_;
    next.set_keep_going(keep_going_);
    next.mouse_is_off_ = mouse_is_off_;
    next.has_bell_ = has_bell_;
    if (table_ && next.table_)
        next.table_->continue_from(*table_, next.session_.scene().table.highscores);
    next.set_key_release(key_release_);
    if (opponent_) next.set_opponent(opponent_->steadiness());
    next.shows_cursor_ = shows_cursor_;
    if (next.session_.scene().view == session_.scene().view) {
        next.camera_ = camera_;
        next.is_fitted_ = is_fitted_;
        next.pointer_ = pointer_;
    }
    return next;
}

void Player::say(std::string message) {
    message_ = std::move(message);
    message_is_error_ = false;
    message_seconds_ = message_time;
    needs_draw_ = true;
}

void Player::complain(std::string message) {
    say(std::move(message));
    message_is_error_ = true;
}

void Player::set_problem(std::optional<std::string> problem) {
    problem_ = std::move(problem);
    needs_draw_ = true;
}

void Player::set_view(const ViewOptions& view) {
    view_ = view;
    needs_draw_ = true;
}

void Player::pause(bool paused) {
    clock_.pause(paused);
    needs_draw_ = true;
}

void Player::set_keep_going(const KeepGoing& keep_going) {
    keep_going_ = keep_going;
    session_.set_keep_going(keep_going);
}

double Player::seconds_to_change() const {
    const bool is_idle =
        stands_still() && !is_ahead() && !(seat_ && seat_->has_work()) && !coach_is_asked_;
    if (!is_idle && !is_too_small_ && page_ == Page::none) return 0.0;
    return message_seconds_ > 0.0 ? message_seconds_ : std::numeric_limits<double>::infinity();
}

void Player::advance(double seconds, const MayGoOn& may_go_on) {
    if (message_seconds_ > 0.0) {
        message_seconds_ -= seconds;
        needs_draw_ = needs_draw_ || message_seconds_ <= 0.0;
    }
    if (is_too_small_ || page_ != Page::none) return;
    if (table_) {
        press_buttons(table_->pass(seconds));
        table_->follow(session_, seconds);
    }
    if (seat_ && seat_->work(session_)) needs_draw_ = true;
    play_opponent(seconds);
    hear_coach();
    // What runs beside the game keeps up with it, or the game waits.
    if (!keep_up(may_go_on) || stands_still()) return;
    const bool was_seeking = clock_.is_seeking();
    prepare();
    keep_up(may_go_on);
    const bool was_at_end = session_.is_at_end();
    play_demonstration();
    const auto both_may_go_on = [&] {
        play_demonstration();
        return keep_up(may_go_on) && may_go_on();
    };
    if (clock_.advance(session_, seconds, both_may_go_on) > 0) needs_draw_ = true;
    keep_up(may_go_on);
    tell_outcome();
    hear_table(seconds);
    hear_referee();
    if (was_seeking && !clock_.is_seeking()) {
        if (session_.is_at_end())
            say("nothing meets any more: the recording ends here");
        else if (clock_.search_failed())
            complain("nothing met for ten minutes of the level's time");
        needs_draw_ = true;
    }
    if (session_.is_at_end() && !was_at_end && !was_seeking) say("the recording ends here");
}

void Player::prepare() {
    if (!is_watching()) tool_.prepare(session_);
}

// What others do to the world is no drift of its energy.
void Player::watch_commands() {
    const auto commands = session_.commands();
    const auto next =
        std::ranges::upper_bound(commands, session_.world().tick, {}, &TimedCommand::tick);
    const auto count = static_cast<std::size_t>(next - commands.begin());
    if (count != commands_watched_) set_reference();
    commands_watched_ = count;
}

void Player::set_reference() {
    const World& world = session_.world();
    const Totals sums = totals(world);
    reference_ = {world.tick, sums.kinetic_energy + sums.potential_energy, sums.momentum, 0.0};
    for (std::size_t i = 0; i < world.balls.size(); ++i)
        reference_.momentum_scale += length(world.balls.velocity[i]) / world.balls.inverse_mass[i];
}

PlayRequest Player::perform(Action action) {
    needs_draw_ = true;
    switch (action) {
        case Action::quit:
            return PlayRequest::quit;
        case Action::menu:
            return escape();
        case Action::save:
            return PlayRequest::save;
        case Action::mouse:
            return PlayRequest::toggle_mouse;
        case Action::resume:
            return PlayRequest::resume;
        case Action::help:
            page_ = Page::help;
            page_scroll_ = 0;
            return PlayRequest::none;
        default:
            break;
    }
    if (is_watching() && action >= Action::grab && action <= Action::turn_gravity)
        say("a recording is only watched");
    else if (action <= Action::restart)
        perform_in_time(action);
    else if (action <= Action::undo)
        perform_by_hand(action);
    else if (action <= Action::turn_gravity)
        perform_on_world(action);
    else
        perform_on_view(action);
    keep_up([] { return false; });
    return PlayRequest::none;
}

/// Lets go of what is in the hand; then of the cursor; then of the game.
PlayRequest Player::escape() {
    if (!tool_.is_empty() || cue_is_armed_) {
        tool_.cancel(session_);
        cue_is_armed_ = false;
        pressed_.reset();
        return PlayRequest::none;
    }
    if (shows_cursor_ || selected_) {
        shows_cursor_ = false;
        selected_.reset();
        follows_ = false;
        return PlayRequest::none;
    }
    return PlayRequest::menu;
}

void Player::perform_in_time(Action action) {
    switch (action) {
        case Action::pause:
            clock_.pause(!clock_.is_paused() || clock_.is_seeking());
            break;
        case Action::step_forward:
            clock_.pause(true);
            prepare();
            step();
            break;
        case Action::step_back:
            clock_.pause(true);
            if (session_.world().tick == session_.earliest())
                say(session_.earliest() == 0 ? "this is the start"
                                             : "the memory for the way back ends here");
            else
                go_to(session_.world().tick - 1);
            break;
        case Action::next_collision:
            prepare();
            clock_.seek_collision();
            break;
        case Action::second_forward:
            second(1);
            break;
        case Action::second_back:
            second(-1);
            break;
        case Action::slower:
            clock_.slower();
            say(fmt::format("speed x{:g}", clock_.speed()));
            break;
        case Action::faster:
            clock_.faster();
            say(fmt::format("speed x{:g}", clock_.speed()));
            break;
        case Action::normal_speed:
            clock_.normal();
            say("normal speed");
            break;
        default:
            if (is_watching()) {
                go_to(0);
            } else {
                tool_.forget();
                session_.restart();
            }
            set_reference();
            energy_.clear();
            say("from the start");
            break;
    }
}

void Player::go_to(std::uint64_t tick) {
    tool_.forget();
    session_.go_to(tick);
    if (comparison_) comparison_->follow(session_, keep_going_, keep_going_);
    if (session_.world().tick < reference_.tick) set_reference();
}

void Player::second(int direction) {
    const auto rate = static_cast<std::uint64_t>(std::max(1.0, session_.world().rate));
    const std::uint64_t now = session_.world().tick;
    if (direction < 0) {
        go_to(now - session_.earliest() > rate ? now - rate : session_.earliest());
        return;
    }
    prepare();
    for (std::uint64_t tick = 0; tick < rate && step(); ++tick) {
    }
}

/// False at the end of a recording.
bool Player::step() {
    // A parting is not to be missed; the butterfly catches up later.
    if (comparison_) comparison_->follow(session_, keep_going_, keep_going_);
    const bool is_done = session_.step_forward();
    if (comparison_) comparison_->follow(session_, keep_going_, keep_going_);
    if (session_.is_at_end() && !is_done) say("the recording ends here");
    if (session_.outcome() == TickOutcome::given_up) say("the tick took long and was given up");
    tell_outcome();
    return is_done;
}

void Player::tell_outcome() {
    if (session_.outcome() == TickOutcome::too_dense)
        complain("too dense for events: time stood still");
}

bool ends_tick(const InputEvent& event, const KeyMap& keys) {
    using enum InputEvent::Action;
    switch (event.kind) {
        case InputEvent::Kind::mouse:
            return event.action == press || event.action == release;
        case InputEvent::Kind::key:
            return button_of(event) || (event.action != release && keys.action_of(key_of(event)));
        default:
            return true;
    }
}

}  // namespace carom
