#include "game/pinball/pinball_players.h"

#include <fmt/format.h>

#include <algorithm>

namespace carom {
namespace {

void park(Pinball game) {
    PinballState& state = game.state;
    state.parked[state.rules.player] = {state.score, state.extra_balls, state.has_replay,
                                        state.is_lit};
}

void take_up(Pinball game) {
    PinballState& state = game.state;
    const PinballState::Parked& mine = state.parked[state.rules.player];
    state.score = mine.score;
    state.extra_balls = mine.extra_balls;
    state.has_replay = mine.has_replay;
    for (std::uint32_t i = 0; i < game.table().devices.size(); ++i) {
        // Balls in locks stay there for whoever comes next.
        if (traits(game.table().devices[i].kind).light == DeviceLight::ball) continue;
        const bool drops = game.table().devices[i].kind == DeviceKind::droptarget;
        set_lit(game, i, !drops && i < mine.is_lit.size() && mine.is_lit[i] != 0);
        if (drops) state.is_rising[i] = 1;
    }
}

}  // namespace

void begin_players(PinballState& state) {
    state.rules.player = 0;
    state.players = 1;
    state.has_replay = false;
    state.parked.clear();
}

bool may_join(const Scene& scene, const PinballState& state) {
    return state.players < scene.rules.players && state.ball == 1 &&
           state.phase != PinballState::Phase::over;
}

void join(Pinball game) {
    PinballState& state = game.state;
    if (!may_join(game.scene, state)) return;
    state.parked.resize(++state.players);
    game.say(fmt::format("PLAYER {} JOINS", state.players), 2.0);
}

bool pass_to_next_player(Pinball game) {
    PinballState& state = game.state;
    const std::uint32_t players = state.players;
    const bool is_last = state.rules.player + 1 == players;
    if (is_last && state.ball >= game.table().balls) return false;
    if (is_last) ++state.ball;
    if (players == 1) return true;
    park(game);
    state.rules.player = is_last ? 0 : state.rules.player + 1;
    take_up(game);
    game.say(fmt::format("PLAYER {}", state.rules.player + 1), 3.0);
    return true;
}

void award_replay(Pinball game) {
    PinballState& state = game.state;
    const std::int64_t least = game.table().replay;
    if (least == 0 || state.has_replay || state.score < least || !game.is_scoring()) return;
    state.has_replay = true;
    ++state.extra_balls;
    game.say("REPLAY: EXTRA BALL", 3.0);
}

std::vector<std::int64_t> scores_of(const PinballState& state) {
    if (state.parked.empty()) return {state.score};
    std::vector<std::int64_t> scores;
    for (std::size_t i = 0; i < state.parked.size(); ++i)
        scores.push_back(i == state.rules.player ? state.score : state.parked[i].score);
    return scores;
}

std::int64_t best_score(const PinballState& state) {
    return std::ranges::max(scores_of(state));
}

}  // namespace carom
