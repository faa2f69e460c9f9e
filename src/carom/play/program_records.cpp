// What the program keeps from one game to the next: settings, and the record of pool matches.

#include <fmt/format.h>

#include <cmath>

#include "carom/files/high_scores.h"
#include "carom/files/pool_record.h"
#include "carom/play/program.h"

namespace carom {

void Program::keep_setting(std::string_view name, std::string_view value) {
    const std::optional<std::string> fault = write_preference(name, value);
    auto* game = std::get_if<RunningGame>(&page_);
    if (!fault || !game || has_told_lost_settings_) return;
    has_told_lost_settings_ = true;
    game->player.say(fmt::format("such choices are not kept: {}", *fault));
}

// What was learnt is written when the game ends, not while a ball is in play.
void Program::keep_key_repeat(const RunningGame& game) {
    constexpr double like = 0.15;
    const std::optional<KeyRepeatTimes>& before = preferences_.key_repeat;
    const std::optional<KeyRepeatTimes>& now = game.player.terminal().key_repeat;
    if (!now || (before && std::abs(now->delay - before->delay) <= like * before->delay &&
                 std::abs(now->period - before->period) <= like * before->period))
        return;
    preferences_.key_repeat = now;
    keep_setting("key-repeat", text_of(*now));
}

void Program::keep_pool_record(RunningGame& game, bool all) {
    PoolPlayers* const players = game.player.pool_players();
    const auto since = players ? players->take_record(all) : std::nullopt;
    if (!since) return;
    const PoolRecordText kept = carom::keep_pool_record(*since);
    if (kept.problem) game.player.complain(*kept.problem);
    const std::size_t before = rungs_climbed(players->record_before());
    players->set_record(kept.record);
    if (rungs_climbed(kept.record) == before) return;
    game.player.say(climb_text(kept.record));
    game.entry = next_challenge(kept.record);
}

void Program::keep_stars(RunningGame& game) {
    const int stars = stars_of(game.player.session().game());
    const PoolPlayers* const players = game.player.pool_players();
    if (stars <= game.stars || (players && !players->keeps_stars(game.player.session()))) return;
    game.stars = stars;
    if (const auto problem =
            carom::keep_stars(game.stars_name.empty() ? game.source.path : game.stars_name, stars))
        game.player.complain(*problem);
}

}  // namespace carom
