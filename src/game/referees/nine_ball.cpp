#include <fmt/format.h>

#include "game/referees/referee.h"
#include "game/referees/rotation.h"
#include "game/referees/ruling.h"

/// 9-ball: the lowest ball must be hit first, nothing is called, and pocketing the 9 wins. The 9 on
/// the break wins, or is spotted if `PoolOptions` says so, as in some leagues.
namespace carom {
namespace {

constexpr int nine = 9;

class NineBall final : public Referee {
  public:
    std::string_view game() const override { return "nineball"; }
    std::uint8_t id() const override { return 1; }

    bool may_hit_first(const PoolState& state, int ball) const override {
        return ball == lowest_ball(state, nine);
    }

    std::string_view declarations() const override { return "push-out"; }
    std::string_view why_no_call(const PoolState&, PoolCall::Kind) const override {
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
        ruling.foul = rotation_foul(state, shot, is_push);
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
            penalize_rotation(ruling);
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

    PoolRuling judge_time(const PoolState& state) const override {
        return late_in_rotation(Referee::judge_time(state), state);
    }

    std::string target_text(const PoolState& state) const override {
        return fmt::format("on the {}", lowest_ball(state, nine));
    }

    std::string_view reason_text(const PoolState& state, const PoolCall&, const PoolShot&,
                                 int) const override {
        return may_choose(state, PoolChoice::return_push) ? "a push-out" : "";
    }
};

}  // namespace

const Referee& nine_ball_referee() {
    static const NineBall referee;
    return referee;
}

}  // namespace carom
