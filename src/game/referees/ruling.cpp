#include "game/referees/ruling.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "game/referees/referee.h"

namespace carom {

bool is_pocketed(const PoolShot& shot, int ball) {
    return std::ranges::count(shot.pocketed, ball, &PoolShot::Pocketed::ball) > 0;
}

std::uint32_t pocketed_object_balls(const PoolShot& shot) {
    std::uint32_t balls = 0;
    for (const PoolShot::Pocketed& pocketed : shot.pocketed)
        if (pocketed.ball != cue_ball) balls |= ball_bit(pocketed.ball);
    return balls;
}

bool made_call(const PoolShot& shot, const PoolCall& call) {
    return call.kind == PoolCall::Kind::pot &&
           std::ranges::count(shot.pocketed, PoolShot::Pocketed{call.ball, call.pocket}) > 0;
}

bool is_open_break(const PoolShot& shot) {
    constexpr int enough_railed = 4;
    return pocketed_object_balls(shot) != 0 ||
           std::popcount(shot.railed & ~ball_bit(cue_ball)) >= enough_railed;
}

PoolFoul common_foul(const PoolState& state, const PoolShot& shot) {
    if (is_pocketed(shot, cue_ball)) return PoolFoul::scratch;
    if (!shot.first_hit) return PoolFoul::no_hit;
    if (!may_hit_first(state, *shot.first_hit)) return PoolFoul::wrong_ball;
    const bool was_behind =
        state.phase == PoolPhase::playing && state.in_hand == CueInHand::behind_head_string;
    if (was_behind && shot.hit_behind_string) return PoolFoul::behind_string;
    if (pocketed_object_balls(shot) == 0 && !shot.rail_after_hit) return PoolFoul::no_rail;
    return PoolFoul::none;
}

PoolRuling ruling_after(const PoolState& state, const PoolShot& shot) {
    PoolRuling ruling;
    ruling.next = state;
    ruling.next.phase = PoolPhase::playing;
    ruling.next.in_hand = CueInHand::no;
    ruling.next.down |= pocketed_object_balls(shot);
    return ruling;
}

void pass_turn(PoolState& state) {
    state.player = 1 - state.player;
    state.run = 0;
}

bool counts_to_limit(PoolState& state, int player) {
    int& fouls = state.fouls[static_cast<std::size_t>(player)];
    ++fouls;
    const int most = state.options.fouls_that_lose;
    return most > 0 && fouls >= most;
}

void score_points(PoolState& state, int points) {
    state.score[static_cast<std::size_t>(state.player)] += points;
    state.run += points;
}

void win(PoolState& state, int player) {
    state.phase = PoolPhase::over;
    state.winner = player;
    state.in_hand = CueInHand::no;
    state.may_push_out = false;
}

void let_choose(PoolState& state, std::vector<PoolChoice> choices) {
    state.phase = PoolPhase::choosing;
    state.choices = std::move(choices);
}

bool may_choose(const PoolState& state, PoolChoice choice) {
    return state.phase == PoolPhase::choosing && std::ranges::count(state.choices, choice) > 0;
}

std::string_view uncalled_text(const PoolState& state, const PoolCall& call, const PoolShot& shot,
                               int shooter) {
    const bool passes = !state.winner && state.player != shooter;
    if (!passes || pocketed_object_balls(shot) == 0) return "";
    if (call.kind == PoolCall::Kind::safety) return "a safety was called";
    const bool is_named = call.kind == PoolCall::Kind::pot && is_pocketed(shot, call.ball);
    return is_named ? "another pocket was called" : "not a called pot";
}

void spot(PoolRuling& ruling, int ball) {
    ruling.respot.push_back(ball);
    ruling.next.down &= ~ball_bit(ball);
}

void spot_all(PoolRuling& ruling, std::uint32_t balls) {
    for (int ball = 31; ball > cue_ball; --ball)
        if ((balls & ball_bit(ball)) != 0) spot(ruling, ball);
}

}  // namespace carom
