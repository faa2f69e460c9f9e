#include "carom/pool/pool_status.h"

#include <utility>

namespace carom {

const PoolPlay* pool_of(const Session& session) {
    return std::get_if<PoolPlay>(&session.game());
}

void add_pool_title(const Session& session, const PlayerNames& names,
                    std::optional<double> time_left, HudInfo& info) {
    const PoolPlay* const pool = pool_of(session);
    if (!pool) return;
    info.title_comes_first = true;
    info.title = turn_text(*pool, names) + (time_left ? ", " + clock_text(*time_left) : "");
}

std::optional<std::string> ShotAnnouncer::tell(const Session& session, const PlayerNames& names) {
    const PoolPlay* const pool = pool_of(session);
    if (!pool) return std::nullopt;
    std::string now = outcome_text(*pool, names);
    if (now == told_) return std::nullopt;
    told_ = std::move(now);
    return told_.empty() ? std::nullopt : std::optional(told_);
}

void ShotAnnouncer::skip(const Session& session, const PlayerNames& names) {
    if (const PoolPlay* const pool = pool_of(session)) told_ = outcome_text(*pool, names);
}

}  // namespace carom
