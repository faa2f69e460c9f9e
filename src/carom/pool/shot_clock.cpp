#include "carom/pool/shot_clock.h"

#include <algorithm>

#include "carom/pool/pool_status.h"

namespace carom {

ShotClock::Turn ShotClock::turn_of(const PoolPlay& pool) {
    return {pool.shots, pool.frames[0] + pool.frames[1], pool.rules.player, pool.breaker,
            pool.rules.phase};
}

std::optional<double> ShotClock::left(const Session& session) const {
    const PoolPlay* const pool = pool_of(session);
    const double limit = session.scene().pool.clock;
    if (!pool || limit == 0.0 || !is_awaited(*pool)) return std::nullopt;
    return std::max(0.0, limit - (turn_ == turn_of(*pool) ? gone_ : 0.0));
}

bool ShotClock::pass(const Session& session, double seconds) {
    if (!left(session)) return false;
    const Turn turn = turn_of(*pool_of(session));
    if (turn_ != turn) gone_ = 0.0;
    turn_ = turn;
    gone_ += seconds;
    return left(session) == 0.0;
}

void ShotClock::resume(const Session& session, double left) {
    const PoolPlay* const pool = pool_of(session);
    if (!pool) return;
    turn_ = turn_of(*pool);
    gone_ = std::max(0.0, session.scene().pool.clock - left);
}

}  // namespace carom
