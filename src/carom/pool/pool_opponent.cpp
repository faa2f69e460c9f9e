#include "carom/pool/pool_opponent.h"

#include <fmt/format.h>

#include "carom/pool/pool_status.h"
#include "game/ai/opponents.h"

namespace carom {
namespace {

constexpr int own_player = 1;  ///< the index of the AI player
constexpr int coach_skill = 3;

}  // namespace

void PoolOpponent::set(int number) {
    ai_.reset();
    if (number > 0) ai_.emplace(number);
    seconds_left_ = 0.0;
}

bool PoolOpponent::is_turn(const Session& session) const {
    const PoolPlay* const pool = pool_of(session);
    return ai_ && pool && pool->rules.player == own_player && pool->rules.phase != PoolPhase::over;
}

void PoolOpponent::play(PlayContext& play, double seconds) {
    Session& session = play.session;
    if (!is_turn(session)) {
        hesitate();
        says_.clear();
        return;
    }
    const PoolPlay& pool = *pool_of(session);
    if (pool.is_shooting || play.clock.is_paused() || session.world().tick() < session.latest())
        return;
    play.needs_draw = true;
    const bool chooses = pool.rules.phase == PoolPhase::choosing;
    if (seconds_left_ <= 0.0) says_.clear();
    if (!chooses && !ai_->think(session)) return;
    if (seconds_left_ <= 0.0) {
        const AiPlayer& player = ai_player(ai_->number());
        seconds_left_ = player.style.pause;
        if (!chooses)
            says_ = fmt::format("{}: {}", player.name,
                                candidate_text(session.scene(), ai_->candidates().front()));
        return;
    }
    seconds_left_ -= seconds;
    if (seconds_left_ > 0.0) return;
    for (const Command& command : ai_->decision(session))
        if (const auto why_not = session.apply(command)) complain(play, *why_not);
    ai_->forget();
    set_reference(play);
}

const CandidateShot* PoolOpponent::announced(const Session& session) const {
    const bool is_due = is_turn(session) && !pool_of(session)->is_shooting && !says_.empty();
    if (!is_due || !ai_->is_about(session) || ai_->candidates().empty()) return nullptr;
    return &ai_->candidates().front();
}

std::string PoolOpponent::text() const {
    if (!says_.empty() || !ai_) return says_;
    return fmt::format("{} thinks", ai_player(ai_->number()).name);
}

const CandidateShot* PoolCoach::think(const Session& session) {
    if (!ai_) ai_.emplace(coach_skill);
    const bool was_done = ai_->is_about(session) && !ai_->candidates().empty();
    if (!ai_->think(session)) return nullptr;
    is_asked_ = false;
    proposed_ = was_done ? (proposed_ + 1) % ai_->candidates().size() : 0;
    return &ai_->candidates()[proposed_];
}

std::string PoolCoach::text(const Scene& scene) const {
    return fmt::format("{} of {}: {}", proposed_ + 1, ai_->candidates().size(),
                       candidate_text(scene, ai_->candidates()[proposed_]));
}

}  // namespace carom
