#include <fmt/format.h>

#include "game/referees/referee.h"
#include "game/referees/rotation.h"
#include "game/referees/ruling.h"

/// 10-ball: as 9-ball, but every pot is called after the break, a ball pocketed otherwise lets the
/// opponent choose who shoots, and the 10 wins only if it was called.
namespace carom {
namespace {

constexpr int ten = 10;

class TenBall final : public Referee {
  public:
    std::string_view game() const override { return "tenball"; }
    std::uint8_t id() const override { return 2; }

    bool may_hit_first(const PoolState& state, int ball) const override {
        return ball == lowest_ball(state, ten);
    }

    std::string_view declarations() const override { return "safety, or push-out"; }
    std::string_view why_no_call(const PoolState& state, PoolCall::Kind) const override {
        return state.phase == PoolPhase::breaking ? "nothing is called on the break" : "";
    }

    PoolRuling judge(const PoolState& state, const PoolCall& call,
                     const PoolShot& shot) const override {
        PoolRuling ruling = ruling_after(state, shot);
        PoolState& next = ruling.next;
        const int player = state.player;
        const bool is_break = state.phase == PoolPhase::breaking;
        const bool is_push = state.may_push_out && call.kind == PoolCall::Kind::push_out;
        const bool made = made_call(shot, call) && !is_break;
        next.may_push_out = false;
        ruling.foul = rotation_foul(state, shot, is_push);
        const bool is_foul = ruling.foul != PoolFoul::none;
        if (is_pocketed(shot, ten)) {
            if (!is_foul && made && call.ball == ten) {
                win(next, player);
                return ruling;
            }
            spot(ruling, ten);
        }
        if (is_foul) {
            penalize_rotation(ruling);
            return ruling;
        }
        next.fouls[static_cast<std::size_t>(player)] = 0;
        const bool has_pocketed = pocketed_object_balls(shot) != 0;
        if (is_break) {
            if (!has_pocketed) pass_turn(next);
            next.may_push_out = true;
        } else if (is_push || (has_pocketed && !made)) {
            pass_turn(next);
            let_choose(next, {PoolChoice::take_table, PoolChoice::return_push});
        } else if (!made) {
            pass_turn(next);
        }
        return ruling;
    }

    PoolRuling judge_time(const PoolState& state) const override {
        return late_in_rotation(Referee::judge_time(state), state);
    }

    std::string target_text(const PoolState& state) const override {
        return fmt::format("on the {}", lowest_ball(state, ten));
    }

    std::string_view reason_text(const PoolState& state, const PoolCall& call, const PoolShot& shot,
                                 int shooter) const override {
        if (!may_choose(state, PoolChoice::return_push)) return "";
        const std::string_view uncalled = uncalled_text(state, call, shot, shooter);
        return uncalled.empty() ? "a push-out" : uncalled;
    }
};

}  // namespace

const Referee& ten_ball_referee() {
    static const TenBall referee;
    return referee;
}

}  // namespace carom
