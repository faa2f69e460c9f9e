#include "carom/pool/pool_players.h"

#include <array>

#include "game/ai/opponents.h"

namespace carom {

bool PoolPlayers::set_opponent(const Session& session, int number) {
    if (!pool_of(session)) return false;
    opponent_.set(number);
    announcer_.skip(session, names());
    return true;
}

PlayerNames names_against(int opponent) {
    if (opponent > 0) return {"you", std::string(ai_player(opponent).name)};
    return {"player 1", "player 2"};
}

PlayerNames PoolPlayers::names() const {
    return names_against(opponent());
}

bool PoolPlayers::set_match(const Session& session, bool is_match) {
    const ShotsState* const shots = shots_of(session);
    if (!shots || (shots->shots > 0 && !shots->is_over)) return false;
    is_match_ = is_match;
    return true;
}

bool PoolPlayers::is_match(const Session& session) const {
    if (shots_of(session)) return is_match_.value_or(session.scene().rules.may_miss);
    return pool_of(session) && (opponent() > 0 || session.scene().pool.race > 0);
}

PoolRecord PoolPlayers::record() const {
    PoolRecord all = record_;
    add(all, tally_.since());
    return all;
}

std::optional<PoolRecord> PoolPlayers::take_record(bool all) {
    if (!tally_.has_ended() && !all) return std::nullopt;
    const PoolRecord since = tally_.take();
    return since == PoolRecord{} ? std::nullopt : std::optional(since);
}

void PoolPlayers::give_up(const Session& session) {
    tally_.give_up(*pool_of(session), opponent());
}

void PoolPlayers::pass(PlayContext& play, double seconds) {
    opponent_.play(play, seconds);
    count_time(play, seconds);
    tally(play, seconds);
}

std::optional<std::string> PoolPlayers::tell_outcome(const Session& session) {
    return announcer_.tell(session, names());
}

// No clock runs for the opponent, nor while the player looks at the past.
void PoolPlayers::count_time(PlayContext& play, double seconds) {
    const Session& session = play.session;
    if (play.clock.is_paused() || is_opponents_turn(session) ||
        session.world().tick() < session.latest() || !clock_.pass(session, seconds))
        return;
    if (const auto why_not = play.session.apply(command::TimeOut{})) complain(play, *why_not);
    set_reference(play);
}

void PoolPlayers::tally(const PlayContext& play, double seconds) {
    const PoolPlay* const pool = pool_of(play.session);
    if (!pool || play.session.world().tick() < play.session.latest()) return;
    tally_.look(*pool, opponent());
    if (is_awaited(*pool) && !is_opponents_turn(play.session) && !play.clock.is_paused())
        tally_.pass(seconds);
}

void PoolPlayers::continue_from(const Session& session, const PoolPlayers& before) {
    hand_ = before.hand_;
    is_match_ = before.is_match_;
    tally_ = before.tally_;
    record_ = before.record_;
    if (before.opponent() > 0) set_opponent(session, before.opponent());
}

bool is_in_match(const Session& session) {
    const PoolPlay* const pool = pool_of(session);
    if (!pool || session.is_following() || match_winner(*pool)) return false;
    return pool->shooter || pool->frames != std::array<std::uint32_t, 2>{};
}

}  // namespace carom
