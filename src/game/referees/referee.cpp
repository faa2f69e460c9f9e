#include "game/referees/referee.h"

#include <algorithm>
#include <array>

#include "game/referees/ruling.h"

namespace carom {

// Each is defined in a file of its own.
const Referee& eight_ball_referee();
const Referee& nine_ball_referee();

std::span<const Referee* const> referees() {
    static const std::array all{&eight_ball_referee(), &nine_ball_referee()};
    return all;
}

const Referee* referee_of(std::string_view game) {
    const auto found = std::ranges::find(referees(), game, &Referee::game);
    return found == referees().end() ? nullptr : *found;
}

bool Referee::loses_by_time(PoolState&) const {
    return false;
}

int Referee::lead(const PoolState&) const {
    return 0;
}

PoolState begin_rack(const Referee& referee, int breaker, const PoolOptions& options) {
    PoolState state;
    state.referee = &referee;
    state.options = options;
    state.player = state.breaker = breaker;
    return state;
}

bool is_down(const PoolState& state, int ball) {
    return (state.down & ball_bit(ball)) != 0;
}

bool may_hit_first(const PoolState& state, int ball) {
    return state.referee->may_hit_first(state, ball);
}

bool may_call_shots(const PoolState& state) {
    const bool is_to_shoot =
        state.phase == PoolPhase::breaking || state.phase == PoolPhase::playing;
    return is_to_shoot && state.referee->why_no_call(state).empty();
}

PoolRuling judge(const PoolState& state, const PoolCall& call, const PoolShot& shot) {
    PoolRuling ruling = state.referee->judge(state, call, shot);
    if (state.options.stalemate > 0) {
        int& idle = ruling.next.idle_shots;
        idle = pocketed_object_balls(shot) == 0 ? idle + 1 : 0;
        if (idle >= state.options.stalemate && ruling.next.phase == PoolPhase::playing) {
            ruling.respot.clear();
            ruling.rerack = true;
            ruling.next = begin_rack(*state.referee, state.breaker, state.options);
        }
    }
    return ruling;
}

bool is_warned(const PoolState& state) {
    const int most = state.options.fouls_that_lose;
    return most > 1 && state.fouls[static_cast<std::size_t>(state.player)] == most - 1;
}

PoolRuling judge_time(const PoolState& state) {
    if (state.phase == PoolPhase::choosing) return choose(state, state.choices.front());
    PoolRuling ruling;
    ruling.foul = PoolFoul::time;
    ruling.next = state;
    PoolState& next = ruling.next;
    next.may_push_out = false;
    if (state.referee->loses_by_time(next)) {
        win(next, 1 - state.player);
        return ruling;
    }
    pass_turn(next);
    next.in_hand =
        state.phase == PoolPhase::breaking ? CueInHand::behind_head_string : CueInHand::anywhere;
    return ruling;
}

PoolRuling choose(const PoolState& state, PoolChoice choice) {
    constexpr int eight = 8;
    PoolRuling ruling;
    ruling.next = state;
    PoolState& next = ruling.next;
    next.choices.clear();
    next.phase = PoolPhase::playing;
    switch (choice) {
        case PoolChoice::take_table:
            break;
        case PoolChoice::return_push:
            pass_turn(next);
            break;
        case PoolChoice::spot_eight:
            spot(ruling, eight);
            break;
        case PoolChoice::break_again:
        case PoolChoice::let_break: {
            const int breaker = choice == PoolChoice::break_again ? state.player : 1 - state.player;
            ruling.rerack = true;
            next = begin_rack(*state.referee, breaker, state.options);
            break;
        }
    }
    return ruling;
}

}  // namespace carom
