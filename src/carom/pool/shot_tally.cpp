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
        if (is_over && !was_over_ && pool.rules.winner) {
            PoolRecord::Frames& frames = since_.opponents[static_cast<std::size_t>(opponent - 1)];
            ++(*pool.rules.winner == person ? frames.won : frames.lost);
            has_ended_ = true;
        }
    }
    // A shot that began before the first look is not counted.
    was_shooting_ = pool.is_shooting && (was_shooting_ || (!is_new && pool.shots != *shots_));
    was_over_ = is_over;
    shots_ = pool.shots;
    if (pool.rules.player != person || is_over) run_ = 0;
}

void ShotTally::count_shot(const PoolPlay& pool) {
    ++since_.shots;
    since_.seconds += std::exchange(waited_, 0.0);
    if (pool.last_foul != PoolFoul::none) {
        ++since_.fouls;
        return;
    }
    if (is_safety_) ++since_.safeties;
    const auto is_object = [](const PoolShot::Pocketed& pocketed) {
        return pocketed.ball != cue_ball;
    };
    const auto balls =
        static_cast<std::uint64_t>(std::ranges::count_if(pool.shot.pocketed, is_object));
    since_.pots += balls;
    run_ += balls;
    since_.best_run = std::max(since_.best_run, run_);
}

std::string text_for_player(const PoolRecord& record) {
    if (record.shots == 0) return "no shot in a match against carom yet";
    std::string text = fmt::format(
        "{} shots, {} balls, best run {}, {} safeties, {} fouls, {:.0f} s a shot; frames",
        record.shots, record.pots, record.best_run, record.safeties, record.fouls,
        record.seconds / static_cast<double>(record.shots));
    for (const PoolRecord::Frames& frames : record.opponents)
        text += fmt::format(" {}:{}", frames.won, frames.lost);
    return text;
}

}  // namespace carom
