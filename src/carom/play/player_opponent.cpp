#include <fmt/format.h>

#include "carom/play/player.h"
#include "game/pool/pool_words.h"

/// carom at the pool table: as the other player, and as a coach.
namespace carom {
namespace {

/// Between saying what it is going to shoot and shooting it, s.
constexpr double opponent_pause = 1.2;
constexpr int carom_plays = 1;  ///< which of the two players carom is

}  // namespace

bool Player::set_opponent(int steadiness) {
    if (!pool()) return false;
    opponent_.reset();
    if (steadiness > 0) opponent_.emplace(steadiness);
    opponent_waits_ = 0.0;
    heard_ = outcome_text(*pool(), names());
    return true;
}

void Player::next_opponent() {
    const int next = opponent_ ? (opponent_->steadiness() + 1) % (most_steadiness + 1) : 1;
    if (!set_opponent(next)) return say("there is no game of pool here");
    say(opponent_ ? fmt::format("against carom, {} of {}: {}", next, most_steadiness,
                                steadiness_text(next))
                  : "two players");
}

// Only in the present: who goes back in time watches.
bool Player::is_opponents_turn() const {
    return opponent_ && pool() && pool()->rules.player == carom_plays &&
           pool()->rules.phase != PoolPhase::over;
}

void Player::play_opponent(double seconds) {
    if (!is_opponents_turn()) {
        opponent_waits_ = 0.0;
        opponent_says_.clear();
    }
    if (!is_opponents_turn() || pool()->is_shooting || clock_.is_paused() || is_watching() ||
        session_.world().tick < session_.latest())
        return;
    needs_draw_ = true;
    const bool chooses = pool()->rules.phase == PoolPhase::choosing;
    if (opponent_waits_ <= 0.0) opponent_says_.clear();
    if (!chooses && !opponent_->think(session_)) return;
    if (opponent_waits_ <= 0.0) {
        opponent_waits_ = opponent_pause;
        if (!chooses)
            opponent_says_ =
                "carom: " + thought_text(session_.scene(), opponent_->thoughts().front());
        return;
    }
    opponent_waits_ -= seconds;
    if (opponent_waits_ > 0.0) return;
    for (const Command& command : opponent_->decision(session_)) {
        const auto why_not = session_.apply(command);
        if (why_not) complain(*why_not);
    }
    opponent_->forget();
    set_reference();
}

// Back to where a person is to play.
void Player::undo() {
    tool_.forget();
    opponent_waits_ = 0.0;
    if (!session_.undo()) return say("nothing to undo");
    while (is_opponents_turn() && session_.undo()) {
    }
    set_reference();
    say("undone");
}

void Player::ask_coach() {
    if (!pool() || !is_aiming()) return say("the coach speaks when you are to shoot");
    if (!coach_) coach_.emplace(3);
    coach_is_asked_ = true;
    say("the coach thinks");
}

// One thought at a time, aimed as it says.
void Player::hear_coach() {
    if (!coach_is_asked_) return;
    if (!is_aiming()) {
        coach_is_asked_ = false;
        return;
    }
    const bool was_done = coach_->is_about(session_) && !coach_->thoughts().empty();
    if (!coach_->think(session_)) return;
    coach_is_asked_ = false;
    const std::vector<PoolThought>& thoughts = coach_->thoughts();
    coach_told_ = was_done ? (coach_told_ + 1) % thoughts.size() : 0;
    const PoolThought thought = thoughts[coach_told_];
    const std::size_t count = thoughts.size();
    if (thought.place) {
        const BallId ball = *seat_->cue_ball(session_);
        if (const auto why_not = session_.apply(command::PlaceBall{ball, *thought.place}))
            return complain(*why_not);
    }
    seat_->take(session_, thought);
    say(fmt::format("{} of {}: {}", coach_told_ + 1, count,
                    thought_text(session_.scene(), thought)));
}

}  // namespace carom
