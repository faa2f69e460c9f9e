#include "carom/pool/pool_opponent.h"

#include <fmt/format.h>

#include "carom/pool/pool_status.h"

namespace carom {
namespace {

/// The time between announcing a shot and shooting it, s.
constexpr double pause = 1.2;
constexpr int own_player = 1;  ///< the index of the AI player
constexpr int coach_skill = 3;

}  // namespace

void PoolOpponent::set_skill(int skill) {
    ai_.reset();
    if (skill > 0) ai_.emplace(skill);
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
        seconds_left_ = pause;
        if (!chooses)
            says_ = "carom: " + candidate_text(session.scene(), ai_->candidates().front());
        return;
    }
    seconds_left_ -= seconds;
    if (seconds_left_ > 0.0) return;
    for (const Command& command : ai_->decision(session))
        if (const auto why_not = session.apply(command)) complain(play, *why_not);
    ai_->forget();
    set_reference(play);
}

std::string PoolOpponent::text() const {
    return says_.empty() ? "carom thinks" : says_;
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
