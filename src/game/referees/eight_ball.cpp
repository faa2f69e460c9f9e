#include "game/referees/eight_ball.h"

#include <fmt/format.h>

#include <utility>

#include "game/referees/referee.h"
#include "game/referees/ruling.h"

/// 8-ball: every pot is called, each player has a group, and the 8 comes last.
namespace carom {
namespace {

constexpr int eight = 8;
constexpr int last_ball = 15;

PoolGroup other_group(PoolGroup group) {
    return group == PoolGroup::solids ? PoolGroup::stripes : PoolGroup::solids;
}

int balls_left(const PoolState& state, PoolGroup group) {
    int left = 0;
    for (int ball = 1; ball <= last_ball; ++ball)
        if (group_of(ball) == group && !is_down(state, ball)) ++left;
    return left;
}

PoolRuling judge_break(PoolRuling ruling, const PoolShot& shot) {
    PoolState& next = ruling.next;
    const bool scratched = is_pocketed(shot, cue_ball);
    if (scratched) {
        ruling.foul = PoolFoul::scratch;
        pass_turn(next);
        next.in_hand = CueInHand::behind_head_string;
    }
    if (is_pocketed(shot, eight)) {
        let_choose(next, {PoolChoice::spot_eight, PoolChoice::break_again});
    } else if (!is_open_break(shot)) {
        if (!scratched) pass_turn(next);
        let_choose(next, {PoolChoice::take_table, PoolChoice::break_again, PoolChoice::let_break});
    } else if (!scratched && pocketed_object_balls(shot) == 0) {
        pass_turn(next);
    }
    return ruling;
}

class EightBall final : public Referee {
  public:
    std::string_view game() const override { return "eightball"; }
    std::uint8_t id() const override { return 0; }

    bool may_hit_first(const PoolState& state, int ball) const override {
        if (state.phase == PoolPhase::breaking) return true;
        const auto group = group_of_player(state, state.player);
        if (!group) return ball != eight;
        if (balls_left(state, *group) == 0) return ball == eight;
        return group_of(ball) == group;
    }

    std::string_view declarations() const override { return "safety"; }
    std::string_view why_no_call(const PoolState& state, PoolCall::Kind) const override {
        return state.phase == PoolPhase::breaking ? "nothing is called on the break" : "";
    }

    PoolRuling judge(const PoolState& state, const PoolCall& call,
                     const PoolShot& shot) const override {
        PoolRuling ruling = ruling_after(state, shot);
        if (state.phase == PoolPhase::breaking) return judge_break(std::move(ruling), shot);
        PoolState& next = ruling.next;
        const int player = state.player;
        const auto group = group_of_player(state, player);
        const bool made = made_call(shot, call);
        ruling.foul = common_foul(state, shot);
        if (is_pocketed(shot, eight)) {
            const bool was_on_eight = group && balls_left(state, *group) == 0;
            const bool wins =
                was_on_eight && ruling.foul == PoolFoul::none && made && call.ball == eight;
            win(next, wins ? player : 1 - player);
            return ruling;
        }
        if (ruling.foul != PoolFoul::none) {
            pass_turn(next);
            next.in_hand = CueInHand::anywhere;
            return ruling;
        }
        const auto called_group = made ? group_of(call.ball) : std::nullopt;
        const bool continues_turn = called_group && (!group || called_group == group);
        if (!continues_turn)
            pass_turn(next);
        else if (!group)
            next.group = player == 0 ? *called_group : other_group(*called_group);
        return ruling;
    }

    std::string target_text(const PoolState& state) const override {
        const auto group = group_of_player(state, state.player);
        if (!group) return "open table";
        const int left = balls_left(state, *group);
        if (left == 0) return "on the 8";
        return fmt::format("{}, {} left", *group == PoolGroup::solids ? "solids" : "stripes", left);
    }

    std::string_view reason_text(const PoolState& state, const PoolCall& call, const PoolShot& shot,
                                 int shooter) const override {
        if (may_choose(state, PoolChoice::spot_eight)) return "the 8 fell on the break";
        if (may_choose(state, PoolChoice::let_break))
            return "weak break: fewer than four balls hit a cushion";
        if (!state.winner) return uncalled_text(state, call, shot, shooter);
        if (*state.winner == shooter || !is_pocketed(shot, eight)) return "";
        PoolState before = state;
        before.down &= ~pocketed_object_balls(shot);
        const auto group = group_of_player(before, shooter);
        return group && balls_left(before, *group) == 0 ? "the 8 fell, but not as called"
                                                        : "the 8 fell too early";
    }

    double lead(const PoolState& state) const override {
        const auto group = group_of_player(state, state.player);
        if (!group) return 0.0;
        return balls_left(state, other_group(*group)) - balls_left(state, *group);
    }
};

}  // namespace

const Referee& eight_ball_referee() {
    static const EightBall referee;
    return referee;
}

std::optional<PoolGroup> group_of(int ball) {
    if (ball >= 1 && ball < eight) return PoolGroup::solids;
    if (ball > eight && ball <= last_ball) return PoolGroup::stripes;
    return std::nullopt;
}

std::optional<PoolGroup> group_of_player(const PoolState& state, int player) {
    if (!state.group) return std::nullopt;
    return player == 0 ? *state.group : other_group(*state.group);
}

}  // namespace carom
