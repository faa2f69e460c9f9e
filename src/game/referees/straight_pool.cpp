#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "game/referees/referee.h"
#include "game/referees/ruling.h"

/// Straight pool, 14.1 continuous: every pot is called, any ball counts a point, and when one ball
/// is left the other fourteen are racked again. The points of PoolOptions win.
namespace carom {
namespace {

constexpr int foul_points = 1;
constexpr int breaking_foul_points = 2;
constexpr int third_foul_points = 15;

int balls_on_table(const PoolState& state) {
    return std::popcount(fifteen_balls & ~state.down);
}

// The opening break pockets the called ball, or drives the cue ball and two others to cushions.
bool is_weak_opening(const PoolCall& call, const PoolShot& shot) {
    constexpr int enough_railed = 2;
    if (made_call(shot, call)) return false;
    return (shot.railed & ball_bit(cue_ball)) == 0 ||
           std::popcount(shot.railed & ~ball_bit(cue_ball)) < enough_railed;
}

// Takes points for a foul, and three in a row cost fifteen more, a new rack and its break.
void penalize(PoolRuling& ruling, int points) {
    PoolState& next = ruling.next;
    const int player = next.player;
    ruling.penalty = points;
    const bool is_third = counts_to_limit(next, player);
    if (is_third) ruling.penalty += third_foul_points;
    next.score[static_cast<std::size_t>(player)] -= ruling.penalty;
    if (!is_third) return pass_turn(next);
    next.fouls[static_cast<std::size_t>(player)] = 0;
    ruling.respot.clear();
    ruling.rerack = true;
    next = next.referee->rack_again(next, player);
}

class StraightPool final : public Referee {
  public:
    std::string_view game() const override { return "straightpool"; }
    std::uint8_t id() const override { return 3; }

    bool may_hit_first(const PoolState&, int) const override { return true; }

    std::string_view declarations() const override { return "safety"; }
    std::string_view why_no_call(const PoolState&, PoolCall::Kind) const override { return ""; }

    PoolRuling judge(const PoolState& state, const PoolCall& call,
                     const PoolShot& shot) const override {
        PoolRuling ruling = ruling_after(state, shot);
        PoolState& next = ruling.next;
        const std::uint32_t pocketed = pocketed_object_balls(shot);
        const bool is_break = state.phase == PoolPhase::breaking;
        ruling.foul = common_foul(state, shot);
        const bool scratched = ruling.foul == PoolFoul::scratch;
        const bool is_weak = is_break && is_weak_opening(call, shot);
        if (is_weak) ruling.foul = PoolFoul::weak_opening;
        if (ruling.foul != PoolFoul::none) {
            spot_all(ruling, pocketed);
            next.in_hand = scratched ? CueInHand::behind_head_string : CueInHand::no;
            if (is_weak) return penalize_opening(std::move(ruling));
            penalize(ruling, foul_points);
            return ruling;
        }
        next.fouls[static_cast<std::size_t>(state.player)] = 0;
        if (!made_call(shot, call)) {
            spot_all(ruling, pocketed);
            pass_turn(next);
            return ruling;
        }
        score_points(next, std::popcount(pocketed));
        if (next.score[static_cast<std::size_t>(state.player)] >= state.options.points) {
            win(next, state.player);
        } else if (balls_on_table(next) <= 1) {
            ruling.rack_rest = true;
            next.down = 0;
        }
        return ruling;
    }

    PoolRuling judge_time(const PoolState& state) const override {
        PoolRuling ruling = Referee::judge_time(state);
        if (state.phase == PoolPhase::breaking) {
            ruling.penalty = breaking_foul_points;
            ruling.next.score[static_cast<std::size_t>(state.player)] -= breaking_foul_points;
            return ruling;
        }
        ruling.next = state;
        penalize(ruling, foul_points);
        return ruling;
    }

    // The points of the frame go on.
    PoolState rack_again(const PoolState& state, int breaker) const override {
        PoolState fresh = Referee::rack_again(state, breaker);
        fresh.score = state.score;
        fresh.fouls = state.fouls;
        return fresh;
    }

    std::string target_text(const PoolState& state) const override {
        const int missing =
            state.options.points - state.score[static_cast<std::size_t>(state.player)];
        return state.run > 0 ? fmt::format("run {}, {} to go", state.run, missing)
                             : fmt::format("{} to go", missing);
    }

    std::string_view warning_text() const override { return "the next foul costs 16"; }

    std::string score_text(const PoolState& state) const override {
        return fmt::format("{}:{}", state.score[0], state.score[1]);
    }

    std::string_view reason_text(const PoolState& state, const PoolCall& call, const PoolShot& shot,
                                 int shooter) const override {
        const bool breaks_again = state.phase == PoolPhase::breaking && state.player == shooter;
        return breaks_again ? "3 fouls in a row" : uncalled_text(state, call, shot, shooter);
    }

    double lead(const PoolState& state) const override {
        constexpr double points_a_ball = 4.0;
        constexpr double most = 14.0;
        const auto player = static_cast<std::size_t>(state.player);
        const double points = state.score[player] - state.score[1 - player];
        return std::clamp(points / points_a_ball, -most, most);
    }

    bool breaks_hard() const override { return false; }

  private:
    // A foul on the opening break costs two points, and the opponent may have it repeated. After a
    // scratch the cue ball is in hand behind the head string.
    static PoolRuling penalize_opening(PoolRuling ruling) {
        PoolState& next = ruling.next;
        ruling.penalty = breaking_foul_points;
        next.score[static_cast<std::size_t>(next.player)] -= breaking_foul_points;
        pass_turn(next);
        let_choose(next, {PoolChoice::take_table, PoolChoice::let_break});
        return ruling;
    }
};

}  // namespace

const Referee& straight_pool_referee() {
    static const StraightPool referee;
    return referee;
}

}  // namespace carom
