#include "carom/pool/pool_status.h"

#include <utility>

#include "game/referees/referee.h"
#include "game/rules/goal.h"

namespace carom {

const PoolPlay* pool_of(const Session& session) {
    return std::get_if<PoolPlay>(&session.game());
}

const ShotsState* shots_of(const Session& session) {
    return std::get_if<ShotsState>(&session.game());
}

bool is_break(const Session& session) {
    const PoolPlay* const game = pool_of(session);
    return game && game->rules.phase == PoolPhase::breaking;
}

bool is_safe_opening(const Session& session) {
    const PoolPlay* const game = pool_of(session);
    return game && (is_break(session) || !game->shooter) && !game->rules.referee->breaks_hard();
}

bool has_turns(const Session& session) {
    return pool_of(session) || shots_of(session);
}

std::optional<std::string> outcome_of(const Session& session, const PlayerNames& names) {
    if (const ShotsState* const shots = shots_of(session)) return shots->message;
    if (const PoolPlay* const pool = pool_of(session)) return outcome_text(*pool, names);
    return std::nullopt;
}

void add_pool_title(const Session& session, const PlayerNames& names,
                    std::optional<double> time_left, HudInfo& info) {
    const PoolPlay* const pool = pool_of(session);
    if (!has_turns(session)) return;
    info.title_comes_first = true;
    info.name = session.scene().title;
    // "Snooker" of "Snooker on a 12-ft table".
    info.short_name = info.name.substr(0, info.name.find(" on a "));
    if (!pool) {
        const ShotsState& shots = *shots_of(session);
        info.title = turn_text(session.scene(), shots);
        const std::string task = task_text(session.scene(), session.world(), shots);
        // How the game ended says more than that it has.
        if (shots.is_over && !task.empty() && info.title == "the game is over") info.title.clear();
        if (!task.empty()) info.title += (info.title.empty() ? "" : "   ") + task;
        // Once is enough.
        if (!task.empty() && task == goal_text(session.scene().rules, shots.goal))
            info.goal.clear();
        return;
    }
    info.title =
        turn_text(session.scene(), *pool, names) + (time_left ? ", " + clock_text(*time_left) : "");
}

std::optional<std::string> ShotAnnouncer::tell(const Session& session, const PlayerNames& names) {
    std::optional<std::string> now = outcome_of(session, names);
    if (!now || *now == told_) return std::nullopt;
    told_ = *now;
    return told_.empty() ? std::nullopt : std::move(now);
}

void ShotAnnouncer::skip(const Session& session, const PlayerNames& names) {
    if (auto now = outcome_of(session, names)) told_ = *std::move(now);
}

}  // namespace carom
