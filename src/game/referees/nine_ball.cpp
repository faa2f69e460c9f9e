#include <fmt/format.h>

#include "game/referees/referee.h"
#include "game/referees/ruling.h"

/// 9-ball: the lowest ball must be hit first, nothing is called, and pocketing the 9 wins. The 9 on
/// the break wins, or is spotted if `PoolOptions` says so, as in some leagues.
namespace carom {
namespace {

constexpr int nine = 9;

// Counts one more consecutive foul, and returns whether it loses the frame.
bool counts_to_loss(PoolState& state, int player) {
    int& fouls = state.fouls[static_cast<std::size_t>(player)];
    ++fouls;
    const int most = state.options.fouls_that_lose;
    return most > 0 && fouls >= most;
}

int lowest_ball(const PoolState& state) {
    int ball = 1;
    while (ball < nine && is_down(state, ball))
        ++ball;
    return ball;
}

PoolFoul foul_of(const PoolState& state, const PoolShot& shot, bool is_push) {
    if (is_push) return is_pocketed(shot, cue_ball) ? PoolFoul::scratch : PoolFoul::none;
    const PoolFoul foul = common_foul(state, shot);
    if (state.phase != PoolPhase::breaking) return foul;
    const bool is_weak =
        foul == PoolFoul::no_rail || (foul == PoolFoul::none && !is_open_break(shot));
    return is_weak ? PoolFoul::weak_break : foul;
}

class NineBall final : public Referee {
  public:
    std::string_view game() const override { return "nineball"; }
    std::uint8_t id() const override { return 1; }

    bool may_hit_first(const PoolState& state, int ball) const override {
        return ball == lowest_ball(state);
    }

    std::string_view why_no_call(const PoolState&) const override {
        return "in 9-ball nothing is called";
    }

    PoolRuling judge(const PoolState& state, const PoolCall& call,
                     const PoolShot& shot) const override {
        PoolRuling ruling = ruling_after(state, shot);
        PoolState& next = ruling.next;
        const int player = state.player;
        const bool is_break = state.phase == PoolPhase::breaking;
        const bool is_push = state.may_push_out && call.kind == PoolCall::Kind::push_out;
        next.may_push_out = false;
        ruling.foul = foul_of(state, shot, is_push);
        const bool is_foul = ruling.foul != PoolFoul::none;
        if (is_pocketed(shot, nine)) {
            const bool counts =
                !is_foul && !is_push && (!is_break || state.options.nine_on_break_wins);
            if (counts) {
                win(next, player);
                return ruling;
            }
            spot(ruling, nine);
        }
        if (is_foul) {
            if (counts_to_loss(next, player)) {
                win(next, 1 - player);
                return ruling;
            }
            pass_turn(next);
            next.in_hand = CueInHand::anywhere;
            return ruling;
        }
        next.fouls[static_cast<std::size_t>(player)] = 0;
        if (is_push) {
            pass_turn(next);
            let_choose(next, {PoolChoice::take_table, PoolChoice::return_push});
            return ruling;
        }
        if (pocketed_object_balls(shot) == 0) pass_turn(next);
        next.may_push_out = is_break;
        return ruling;
    }

    bool loses_by_time(PoolState& next) const override { return counts_to_loss(next, next.player); }

    std::string target_text(const PoolState& state) const override {
        return fmt::format("on the {}", lowest_ball(state));
    }
};

}  // namespace

const Referee& nine_ball_referee() {
    static const NineBall referee;
    return referee;
}

}  // namespace carom
