// The challenges of the menu: what is opened for each.

#include "carom/play/program.h"
#include "carom/pool/record_page.h"
#include "game/ai/daily_shot.h"
#include "game/ai/opponents.h"

namespace carom {

void Program::show_record(const Challenge& challenge) {
    const PoolRecordText kept = load_pool_record();
    tell("Your record at pool",
         kept.problem ? Problems{*kept.problem} : record_lines(kept.record, view().look));
    std::get<Notice>(page_).entry = challenge.name;
}

LevelSource Program::source_of(const Challenge& challenge) const {
    LevelSource source = carom::source_of(options_, challenge.level);
    std::vector<std::string> amendments = challenge.amendments;
    if (challenge.kind == Challenge::Kind::daily) {
        const LoadedLevel loaded = load(source);
        const auto shot =
            loaded.result.scene ? daily_shot(*loaded.result.scene, challenge.date) : std::nullopt;
        if (shot) amendments = amendments_of(*shot, challenge.date);
    }
    source.overrides.insert(source.overrides.end(), amendments.begin(), amendments.end());
    return source;
}

void Program::open_challenge(const Challenge& challenge) {
    if (challenge.kind == Challenge::Kind::record) return show_record(challenge);
    if (!challenge.obstacle.empty()) {
        tell("Not yet", {challenge.obstacle});
        std::get<Notice>(page_).entry = challenge.name;
        return;
    }
    open_or_tell(source_of(challenge));
    auto* const game = std::get_if<RunningGame>(&page_);
    if (!game) return;
    game->entry = challenge.name;
    if (challenge.kind == Challenge::Kind::daily) game->stars_name = daily_name(challenge.date);
    PoolPlayers* const players = game->player.pool_players();
    if (challenge.opponent == 0 || !players) return;
    players->set_opponent(game->player.session(), challenge.opponent);
    const AiPlayer& opponent = ai_player(challenge.opponent);
    game->player.say(std::string(opponent.name) + ": " + std::string(opponent.manner));
}

}  // namespace carom
