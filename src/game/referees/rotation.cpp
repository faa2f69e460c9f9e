#include "game/referees/rotation.h"

#include "game/referees/ruling.h"

namespace carom {

int lowest_ball(const PoolState& state, int last) {
    int ball = 1;
    while (ball < last && is_down(state, ball))
        ++ball;
    return ball;
}

PoolFoul rotation_foul(const PoolState& state, const PoolShot& shot, bool is_push) {
    if (is_push) return is_pocketed(shot, cue_ball) ? PoolFoul::scratch : PoolFoul::none;
    const PoolFoul foul = common_foul(state, shot);
    if (state.phase != PoolPhase::breaking) return foul;
    const bool is_weak =
        foul == PoolFoul::no_rail || (foul == PoolFoul::none && !is_open_break(shot));
    return is_weak ? PoolFoul::weak_break : foul;
}

void penalize_rotation(PoolRuling& ruling) {
    PoolState& next = ruling.next;
    if (counts_to_limit(next, next.player)) return win(next, 1 - next.player);
    pass_turn(next);
    next.in_hand = CueInHand::anywhere;
}

PoolRuling late_in_rotation(PoolRuling ruling, const PoolState& state) {
    PoolState& next = ruling.next;
    if (!counts_to_limit(next, state.player)) return ruling;
    next.player = state.player;
    win(next, 1 - state.player);
    return ruling;
}

}  // namespace carom
