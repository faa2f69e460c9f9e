// How an unfinished game is resumed: computed again from its recording, then played on.

#include "carom/controllers/pool_controller.h"
#include "carom/play/program.h"
#include "game/pool/pool.h"

namespace carom {
namespace {

// The solver with which the game began, if its player chose it.
std::optional<SolverSettings> own_solver(const Session& session) {
    const SolverSettings first = session.first_solver();
    return first == solver_of(session.scene()) ? std::nullopt : std::optional(first);
}

// Whether the file of the level is no longer that of the game.
bool has_changed(const Replay& replay, std::size_t rewind_bytes) {
    const LoadedLevel now = load(source_of(replay, rewind_bytes));
    return !now.result.scene || now.result.scene->text_hash != replay.level_hash;
}

}  // namespace

void Program::resume(const InterruptedGame& game) {
    const InterruptedGame taken = game;  // a copy: `game` may live in the page that is replaced
    leave_game();
    auto opened = reopen_game(taken.replay, options_.rewind_bytes);
    if (auto* problems = std::get_if<Problems>(&opened))
        return tell("This game cannot be resumed", std::move(*problems));
    page_.emplace<Resuming>(Resuming{taken, std::move(std::get<Replayer>(opened))});
}

void Program::finish_resuming() {
    Resuming done = std::move(std::get<Resuming>(page_));
    if (const auto& failure = done.replayer.failure())
        return tell("This game cannot be resumed",
                    {"It comes out differently now, so it is left as it is.", *failure});
    LevelSource source = carom::source_of(options_, done.game.replay.level);
    source.rate = done.game.replay.rate;
    source.seed = done.game.replay.seed;
    source.overrides = done.game.replay.overrides;
    source.solver = own_solver(done.replayer.session());
    source.is_earlier = has_changed(done.game.replay, options_.rewind_bytes);
    Player player(std::move(done.replayer).take(), view(), preferences_.keys);
    const Replay& replay = done.game.replay;
    if (replay.setup) player.set_up(*replay.setup);
    if (PoolPlayers* const players = player.pool_players()) {
        players->set_opponent(player.session(), replay.opponent);
        if (replay.time_left) players->set_time_left(player.session(), *replay.time_left);
    }
    if (PinballScores* const scores = player.pinball_scores(); scores && replay.is_unranked)
        scores->leave_out();
    // Where a shot is being aimed, nothing moves before the stroke, which a pause would only stop.
    const bool aims = replay.setup && !replay.time_left && is_at_rest(player.session().world());
    player.pause(!aims);
    const std::string how = source.is_earlier ? "Resumed on its earlier level." : "Resumed.";
    player.say(aims ? how : how + " Press " + preferences_.keys.hint("pause") + " to continue.");
    enter(std::move(source), std::move(player), std::nullopt);
    RunningGame& game = std::get<RunningGame>(page_);
    // The old file stays until the game is saved under its new name.
    if (game.autosave()) forget(done.game);
}

}  // namespace carom
