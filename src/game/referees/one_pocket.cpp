#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "game/referees/referee.h"
#include "game/referees/ruling.h"

/// One-pocket: each player has one pocket at the foot of the table, and eight balls in it win.
namespace carom {
namespace {

constexpr int balls_to_win = 8;
constexpr int ball_count = 15;

bool is_right(const PoolState& state, int player) {
    return player == state.breaker;
}

// The breaker has the pocket on the right. The rules let that player choose, but the table and the
// rack are alike on both sides.
int own_pocket(const PoolState& state, int player) {
    return state.options.foot_pockets[is_right(state, player) ? 0 : 1];
}

std::uint32_t pocketed_in(const PoolShot& shot, int pocket) {
    std::uint32_t balls = 0;
    for (const PoolShot::Pocketed& each : shot.pocketed)
        if (each.pocket == pocket && each.ball != cue_ball) balls |= ball_bit(each.ball);
    return balls;
}

// Balls that count for a player. One who owes balls pays with them first.
void count_balls(PoolState& next, int player, std::uint32_t balls) {
    for (int ball = 1; ball <= ball_count; ++ball) {
        if ((balls & ball_bit(ball)) == 0) continue;
        int& score = next.score[static_cast<std::size_t>(player)];
        if (score < 0) next.waiting |= ball_bit(ball);
        ++score;
    }
}

// One ball of the player's comes back to the table; one who has none owes it. Any ball that is down
// may stand for it: nobody asks which.
void pay(PoolState& next, int player) {
    int& score = next.score[static_cast<std::size_t>(player)];
    if (score > 0)
        for (int ball = ball_count; ball >= 1; --ball)
            if (is_down(next, ball) && (next.waiting & ball_bit(ball)) == 0) {
                next.waiting |= ball_bit(ball);
                break;
            }
    --score;
}

void spot_waiting(PoolRuling& ruling) {
    spot_all(ruling, std::exchange(ruling.next.waiting, 0));
}

class OnePocket final : public Referee {
  public:
    std::string_view game() const override { return "onepocket"; }
    std::uint8_t id() const override { return 4; }

    bool may_hit_first(const PoolState&, int) const override { return true; }

    std::optional<int> pocket_of(const PoolState& state, int player) const override {
        return own_pocket(state, player);
    }

    std::string_view why_no_call(const PoolState&, PoolCall::Kind) const override {
        return "in one-pocket nothing is called";
    }

    PoolRuling judge(const PoolState& state, const PoolCall&, const PoolShot& shot) const override {
        PoolRuling ruling = ruling_after(state, shot);
        PoolState& next = ruling.next;
        const int player = state.player;
        const int other = 1 - player;
        const std::uint32_t own = pocketed_in(shot, own_pocket(state, player));
        const std::uint32_t of_other = pocketed_in(shot, own_pocket(state, other));
        ruling.foul = common_foul(state, shot);
        const bool is_foul = ruling.foul != PoolFoul::none;
        const bool scratched = ruling.foul == PoolFoul::scratch;
        next.waiting |= pocketed_object_balls(shot) & ~(own | of_other);
        if (is_foul) next.waiting |= own;
        if (scratched) next.waiting |= of_other;
        if (!is_foul) {
            next.fouls[static_cast<std::size_t>(player)] = 0;
            count_balls(next, player, own);
            next.run += std::popcount(own);
        }
        if (!scratched) count_balls(next, other, of_other);
        if (ends(next, player) || ends(next, other)) return ruling;
        if (is_foul) return penalized(std::move(ruling));
        if (own == 0) {
            pass_turn(next);
            spot_waiting(ruling);
        } else if ((fifteen_balls & ~next.down) == 0) {
            spot_waiting(ruling);
        }
        return ruling;
    }

    PoolRuling judge_time(const PoolState& state) const override {
        PoolRuling ruling;
        ruling.foul = PoolFoul::time;
        ruling.next = state;
        return penalized(std::move(ruling));
    }

    std::string target_text(const PoolState& state) const override {
        const int has = state.score[static_cast<std::size_t>(state.player)];
        return fmt::format("{} to go", balls_to_win - has);
    }

    std::string score_text(const PoolState& state) const override {
        return fmt::format("{}:{}", state.score[0], state.score[1]);
    }

    double lead(const PoolState& state) const override {
        const auto player = static_cast<std::size_t>(state.player);
        return state.score[player] - state.score[1 - player];
    }

    bool breaks_hard() const override { return false; }

  private:
    static bool ends(PoolState& next, int player) {
        if (next.score[static_cast<std::size_t>(player)] < balls_to_win) return false;
        win(next, player);
        return true;
    }

    // A ball back, and only after a scratch the cue ball in hand.
    static PoolRuling penalized(PoolRuling ruling) {
        PoolState& next = ruling.next;
        const int player = next.player;
        const bool is_late_break =
            ruling.foul == PoolFoul::time && next.phase == PoolPhase::breaking;
        if (ruling.foul == PoolFoul::scratch || is_late_break)
            next.in_hand = CueInHand::behind_head_string;
        ruling.penalty = 1;
        pay(next, player);
        if (counts_to_limit(next, player)) {
            win(next, 1 - player);
            return ruling;
        }
        pass_turn(next);
        spot_waiting(ruling);
        return ruling;
    }
};

}  // namespace

const Referee& one_pocket_referee() {
    static const OnePocket referee;
    return referee;
}

}  // namespace carom
