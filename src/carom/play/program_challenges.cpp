// The challenges of the menu: what is opened for each.

#include "carom/play/program.h"
#include "carom/pool/record_page.h"
#include "game/ai/opponents.h"

namespace carom {

void Program::open_challenge(const Challenge& challenge) {
    if (challenge.kind == Challenge::Kind::record) {
        const PoolRecordText kept = load_pool_record();
        tell("Your record at pool",
             kept.problem ? Problems{*kept.problem} : record_lines(kept.record, view().look));
        std::get<Notice>(page_).entry = challenge.name;
        return;
    }
    if (!challenge.obstacle.empty()) {
        tell("Not yet", {challenge.obstacle});
        std::get<Notice>(page_).entry = challenge.name;
        return;
    }
    open_or_tell(source_of(options_, challenge));
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
