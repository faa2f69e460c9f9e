#include "carom/controllers/pinball_messages.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "game/pinball/pinball.h"

namespace carom {
namespace {

constexpr double least_shown = 1.2;  // s; of a message that another one follows
constexpr double large_shown = 1.8;  // s
constexpr std::size_t most_waiting = 3;
constexpr std::int64_t many_points = 5000;
constexpr double late_balls = 1.0;  // s by which the balls of a message may come after it
constexpr double beats = 4.0;       // of the colours, a second

}  // namespace

PinballMessages::Seen PinballMessages::look(const Session& session) {
    const auto& state = std::get<PinballState>(session.game());
    const auto balls = std::ranges::count_if(session.world().balls().id, [&](BallId ball) {
        return is_in_play(session.scene(), state, ball);
    });
    return {state.message_since, state.score,
            state.rules.player,  static_cast<std::size_t>(balls) + state.to_serve,
            state.warnings,      state.drained};
}

bool PinballMessages::follow(const Session& session) {
    const auto& state = std::get<PinballState>(session.game());
    const std::string before = shown_.text;
    const bool is_earlier = session.world().tick() < tick_;
    tick_ = session.world().tick();
    rate_ = session.world().rate();
    is_said_ = !state.message.empty();
    const Seen now = look(session);
    const Seen then = std::exchange(seen_, now);
    const bool takes_over = !std::exchange(has_looked_, true) || is_earlier ||
                            now.player != then.player || now.score < then.score;
    if (takes_over)
        start_from(session);
    else
        hear(session, now, then);
    pass();
    return !takes_over && shown_.text != before;
}

void PinballMessages::start_from(const Session& session) {
    const auto& state = std::get<PinballState>(session.game());
    waiting_.clear();
    shown_ = {state.message, false};
    shown_since_ = std::min(state.message_since, tick_);
}

void PinballMessages::hear(const Session& session, const Seen& now, const Seen& before) {
    const auto& state = std::get<PinballState>(session.game());
    const bool has_more_balls = now.balls > before.balls && now.balls > 1;
    const bool interrupts = state.is_tilted || state.phase != PinballState::Phase::playing ||
                            !state.is_launched || now.warnings > before.warnings ||
                            now.drained > before.drained;
    if (now.said == before.said || state.message.empty()) {
        const bool is_fresh =
            static_cast<double>(tick_ - std::min(tick_, now.said)) < late_balls * rate_;
        const Message last = waiting_.empty() ? shown_ : waiting_.back();
        if (!has_more_balls || !is_fresh || last.is_large || last.text.empty()) return;
        if (!waiting_.empty()) waiting_.pop_back();
        return show({last.text, true});
    }
    const bool is_large =
        !state.is_tilted && (now.score - before.score >= many_points || has_more_balls);
    if (interrupts) {
        waiting_.clear();
        return show({state.message, is_large});
    }
    take({state.message, is_large});
}

void PinballMessages::take(Message message) {
    const bool is_free = shown_.text.empty() || shown_.text == message.text ||
                         shown_for() >= (shown_.is_large ? large_shown : least_shown);
    if (is_free && waiting_.empty()) return show(std::move(message));
    if (message.is_large && !shown_.is_large) {
        if (shown_for() < least_shown) waiting_.push_front(shown_);
        show(std::move(message));
    } else if (std::ranges::count(waiting_, message.text, &Message::text) == 0) {
        waiting_.push_back(std::move(message));
    }
    if (waiting_.size() <= most_waiting) return;
    const auto plain = std::ranges::find(waiting_, false, &Message::is_large);
    waiting_.erase(plain == waiting_.end() ? waiting_.begin() : plain);
}

void PinballMessages::show(Message message) {
    shown_ = std::move(message);
    shown_since_ = tick_;
}

void PinballMessages::pass() {
    const bool has_been_read = shown_for() >= (shown_.is_large ? large_shown : least_shown);
    if (!waiting_.empty() && (has_been_read || shown_.text.empty())) {
        Message next = std::move(waiting_.front());
        waiting_.pop_front();
        show(std::move(next));
    } else if (has_been_read && !is_said_) {
        shown_ = {};
    }
}

double PinballMessages::shown_for() const {
    return static_cast<double>(tick_ - std::min(tick_, shown_since_)) / rate_;
}

ScorePanel::Moment PinballMessages::moment() const {
    using enum ScorePanel::Moment;
    if (!shown_.is_large || shown_for() >= large_shown) return plain;
    const auto beat = static_cast<std::uint64_t>(2.0 * beats * (large_shown - shown_for()));
    return beat % 2 == 0 ? large_bright : large;
}

}  // namespace carom
