#include "carom/pool/shot_tally.h"

#include <fmt/format.h>

#include <algorithm>

namespace carom {
namespace {

constexpr int person = 0;

}  // namespace

void ShotTally::look(const PoolPlay& pool, int opponent) {
    const bool is_over = pool.rules.phase == PoolPhase::over;
    const bool is_new = !shots_ || pool.shots < *shots_ || opponent == 0;
    if (pool.is_shooting) is_safety_ = pool.call.kind == PoolCall::Kind::safety;
    if (!is_new) {
        if (was_shooting_ && !pool.is_shooting && pool.shooter == person) count_shot(pool);
        if (is_over && !was_over_ && pool.rules.winner)
            count_frame(pool, static_cast<std::size_t>(opponent - 1));
    }
    // A shot that began before the first look is not counted.
    was_shooting_ = pool.is_shooting && (was_shooting_ || (!is_new && pool.shots != *shots_));
    if (pool.is_shooting && !was_shooting_) is_break_ = false;
    if (!pool.is_shooting) is_break_ = pool.rules.phase == PoolPhase::breaking;
    was_over_ = is_over;
    shots_ = pool.shots;
    if (pool.rules.player == person && !is_over) return;
    run_ = 0;
    shots_in_turn_ = 0;
    broke_ = false;
}

void ShotTally::count_shot(const PoolPlay& pool) {
    ++since_.shots;
    since_.seconds += std::exchange(waited_, 0.0);
    if (++shots_in_turn_ == 1) {
        ++since_.turns;
        broke_ = is_break_;
    }
    const bool is_attempt = !is_break_ && !is_safety_;
    if (is_attempt) ++since_.attempts;
    if (pool.last_foul != PoolFoul::none) {
        ++since_.fouls;
        return;
    }
    if (is_safety_) ++since_.safeties;
    const auto is_object = [](const PoolShot::Pocketed& pocketed) {
        return pocketed.ball != cue_ball;
    };
    // A ball that ends the turn was not called, or is the opponent's.
    if (pool.rules.winner.value_or(pool.rules.player) != person) return;
    const auto balls =
        static_cast<std::uint64_t>(std::ranges::count_if(pool.shot.pocketed, is_object));
    if (is_attempt && balls > 0) ++since_.made;
    since_.pots += balls;
    run_ += balls;
    since_.best_run = std::max(since_.best_run, run_);
}

void ShotTally::count_frame(const PoolPlay& pool, std::size_t opponent) {
    const auto add = [&](PoolRecord::Results& results, int winner) {
        ++(winner == person ? results.won : results.lost);
    };
    add(since_.frames[opponent], *pool.rules.winner);
    if (broke_ && *pool.rules.winner == person) ++since_.breaks_and_runs;
    if (const auto winner = match_winner(pool)) add(since_.matches[opponent], *winner);
    has_ended_ = true;
}

void ShotTally::give_up(const PoolPlay& pool, int opponent) {
    if (opponent == 0) return;
    const auto index = static_cast<std::size_t>(opponent - 1);
    if (pool.shooter && pool.rules.phase != PoolPhase::over) ++since_.frames[index].lost;
    if (pool.race > 0) ++since_.matches[index].lost;
    has_ended_ = true;
}

}  // namespace carom
