#include "game/pinball/pinball_players.h"

#include <fmt/format.h>

#include <algorithm>

namespace carom {
namespace {

void park(Pinball game) {
    PinballState& state = game.state;
    state.parked[state.rules.player] = {state.score, state.extra_balls, state.is_lit};
}

void take_up(Pinball game) {
    PinballState& state = game.state;
    const PinballState::Parked& mine = state.parked[state.rules.player];
    state.score = mine.score;
    state.extra_balls = mine.extra_balls;
    for (std::uint32_t i = 0; i < game.table().devices.size(); ++i) {
        const bool drops = game.table().devices[i].kind == DeviceKind::droptarget;
        set_lit(game, i, !drops && i < mine.is_lit.size() && mine.is_lit[i] != 0);
        if (drops) state.is_rising[i] = 1;
    }
}

}  // namespace

void begin_players(const Scene& scene, PinballState& state) {
    state.rules.player = 0;
    state.parked.clear();
    if (scene.rules.players > 1) state.parked.resize(scene.rules.players);
}

bool pass_to_next_player(Pinball game) {
    PinballState& state = game.state;
    const std::uint32_t players = game.scene.rules.players;
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
