#include "game/referees/snooker.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "game/referees/referee.h"
#include "game/referees/ruling.h"
#include "game/referees/snooker_stroke.h"

/// Snooker: reds and colours in turn, then the colours in order.
///
/// A colour, or the free ball, is the one that was called; without a call it is the one that was
/// hit first. A miss is called when no ball on was hit first, unless a player needs penalty points
/// and no ball on was in full view. (A person would also judge how hard the striker tried.)
namespace carom {
namespace {

using namespace snooker;
using On = SnookerTurn::On;

constexpr int most_misses = 3;

void win_by_points(PoolState& next) {
    win(next, next.score[0] > next.score[1] ? 0 : 1);
}

// The scores are equal and nothing is left: the black returns, and a coin decides who plays from
// the D.
void tie(PoolRuling& ruling) {
    PoolState& next = ruling.next;
    if (ruling.respot.empty()) spot(ruling, black);
    next.snooker = {};
    next.snooker.is_tie = true;
    next.snooker.now = {.on = On::in_order, .down = next.down};
    next.in_hand = CueInHand::in_d;
    next.run = 0;
    ruling.toss = true;
    let_choose(next, {PoolChoice::take_table, PoolChoice::return_push});
}

void begin_turn(PoolState& next) {
    pass_turn(next);
    next.snooker.now.on = reds_left(next) > 0 ? On::red : On::in_order;
    next.snooker.now.is_free = false;
}

class Snooker final : public Referee {
  public:
    std::string_view game() const override { return "snooker"; }
    std::uint8_t id() const override { return 5; }

    // There is no break to speak of: the first stroke is judged as any other.
    void begin(PoolState& state) const override {
        state.phase = PoolPhase::playing;
        state.in_hand = CueInHand::in_d;
    }

    bool may_hit_first(const PoolState& state, int ball) const override {
        return is_on(state, ball) || state.snooker.now.is_free;
    }

    std::string_view why_no_call(const PoolState& state, PoolCall::Kind kind) const override {
        if (kind == PoolCall::Kind::safety) return "in snooker a safety is not called";
        const bool names = state.snooker.now.on == On::color || state.snooker.now.is_free;
        return names ? "" : "in snooker only a colour or a free ball is named";
    }

    PoolRuling judge(const PoolState& state, const PoolCall& call,
                     const PoolShot& shot) const override {
        PoolRuling ruling = ruling_after(state, shot);
        PoolState& next = ruling.next;
        const Task task = task_of(state, call, shot);
        const Offence offence = offence_of(state, task, shot);
        const std::uint32_t pocketed = pocketed_object_balls(shot);
        const bool only_black =
            state.snooker.now.on == On::in_order && lowest_color(state) == black;
        next.snooker.before = state.snooker.now;
        next.snooker.before.in_hand = state.in_hand;
        next.snooker.before.down = state.down;
        next.snooker.is_miss = false;
        if (offence.foul != PoolFoul::none) {
            judge_foul(ruling, state, offence, is_pocketed(shot, cue_ball));
        } else {
            next.snooker.misses = 0;
            spot_all(ruling, returning(state, pocketed));
            const int points = points_of(state, task, shot);
            score_points(next, points);
            if (points == 0)
                begin_turn(next);
            else
                go_on(next, state.snooker.now.on);
        }
        if (only_black && (pocketed != 0 || offence.foul != PoolFoul::none)) end(ruling);
        return ruling;
    }

    bool needs_sight() const override { return true; }

    // The free ball, and the snooker behind it that is a foul.
    void see(PoolRuling& ruling, const PoolState& state, const PoolSight& sight) const override {
        PoolState& next = ruling.next;
        if (next.phase == PoolPhase::over || next.snooker.is_tie) return;
        SnookerTurn& now = next.snooker.now;
        const bool was_foul = ruling.foul != PoolFoul::none;
        const bool only_pink_and_black = lowest_color(state) >= pink && reds_left(state) == 0;
        if (!was_foul && state.snooker.now.is_free && next.player != state.player &&
            sight.is_by_called && !only_pink_and_black) {
            const int value = state.snooker.now.on == On::red ? 1 : value_of(lowest_color(state));
            PoolState before = state;
            before.snooker.now.is_free = false;
            next.player = state.player;
            judge_foul(ruling, before, {PoolFoul::hidden, std::max(value, least_penalty)}, false);
        }
        now.is_snookered = sight.is_snookered;
        now.sees_one_full = sight.sees_one_full;
        now.is_free = now.is_free || (ruling.foul != PoolFoul::none && sight.is_snookered);
    }

    PoolRuling judge_time(const PoolState& state) const override {
        PoolRuling ruling;
        ruling.next = state;
        ruling.next.snooker.is_miss = false;
        ruling.next.snooker.before = state.snooker.now;
        const int value = state.snooker.now.on == On::color      ? value_of(black)
                          : state.snooker.now.on == On::in_order ? value_of(lowest_color(state))
                                                                 : 1;
        judge_foul(ruling, state, {PoolFoul::time, std::max(value, least_penalty)}, false);
        ruling.next.in_hand = state.in_hand;
        if (state.snooker.now.on == On::in_order && lowest_color(state) == black) end(ruling);
        return ruling;
    }

    PoolRuling choose(const PoolState& state, PoolChoice choice) const override {
        PoolRuling ruling = Referee::choose(state, choice);
        SnookerState& snooker = ruling.next.snooker;
        if (choice == PoolChoice::replace) {
            ruling.next.down = snooker.before.down;
            ruling.next.in_hand = snooker.before.in_hand;
            snooker.now = snooker.before;
            snooker.misses = snooker.is_miss ? snooker.misses + 1 : 0;
        } else {
            snooker.misses = 0;
            // The free ball is for the player who was snookered by a foul, not for the one who
            // fouled.
            if (choice == PoolChoice::return_push && !snooker.is_tie) snooker.now.is_free = false;
        }
        snooker.is_miss = false;
        return ruling;
    }

    bool is_warned(const PoolState& state) const override {
        return state.snooker.misses == most_misses - 1 && state.snooker.now.sees_one_full;
    }

    bool has_own_spot(int ball) const override { return is_color(ball); }
    bool may_put_back() const override { return true; }

    std::string target_text(const PoolState& state) const override {
        const SnookerTurn& now = state.snooker.now;
        std::string text;
        if (state.snooker.is_tie)
            text = "on the black, which decides";
        else if (now.is_free)
            text = "free ball";
        else if (now.on == On::red)
            text = "on a red";
        else if (now.on == On::color)
            text = "on a colour";
        else
            text = "on " + ball_name(lowest_color(state));
        if (state.run > 0) text += fmt::format(", break {}", state.run);
        return text + fmt::format(", {} left", points_left(state));
    }

    std::string ball_name(int ball) const override {
        constexpr std::array<std::string_view, 6> names{"yellow", "green", "brown",
                                                        "blue",   "pink",  "black"};
        if (is_red(ball)) return "a red";
        return fmt::format("the {}", names[static_cast<std::size_t>(ball - yellow)]);
    }

    bool has_numbers() const override { return false; }
    bool calls_pocket() const override { return false; }

    std::string_view warning_text() const override { return "a third miss loses"; }

    std::string score_text(const PoolState& state) const override {
        return fmt::format("{}:{}", state.score[0], state.score[1]);
    }

    double lead(const PoolState& state) const override {
        constexpr double points_a_ball = 6.0;
        constexpr double most = 8.0;
        const auto player = static_cast<std::size_t>(state.player);
        const double points = state.score[player] - state.score[1 - player];
        return std::clamp(points / points_a_ball, -most, most);
    }

    bool breaks_hard() const override { return false; }

  private:
    static void go_on(PoolState& next, On was) {
        if (was == On::red) {
            next.snooker.now.on = On::color;
        } else if (was == On::color) {
            next.snooker.now.on = reds_left(next) > 0 ? On::red : On::in_order;
        }
        next.snooker.now.is_free = false;
    }

    // Points to the opponent, who may play, or let the striker play again; after a miss also from
    // where the balls lay. A third miss in a row with a ball on in full view loses the frame.
    static void judge_foul(PoolRuling& ruling, const PoolState& state, const Offence& offence,
                           bool scratched) {
        PoolState& next = ruling.next;
        ruling.foul = offence.foul;
        ruling.penalty = offence.penalty;
        const bool could_see = state.snooker.now.sees_one_full;
        const bool lost_before = needs_penalties(state);
        next.score[static_cast<std::size_t>(1 - state.player)] += offence.penalty;
        spot_all(ruling, next.down & ~state.down & all_colors);
        begin_turn(next);
        const bool is_first_hit =
            offence.foul == PoolFoul::no_hit || offence.foul == PoolFoul::wrong_ball;
        const bool is_miss = is_first_hit && (could_see || !(lost_before || needs_penalties(next)));
        next.snooker.is_miss = is_miss && could_see;
        if (scratched) next.in_hand = CueInHand::in_d;
        if (next.snooker.is_miss && next.snooker.misses == most_misses - 1)
            return win(next, next.player);
        std::vector<PoolChoice> choices{PoolChoice::take_table, PoolChoice::return_push};
        if (is_miss) choices.push_back(PoolChoice::replace);
        let_choose(next, std::move(choices));
    }

    // With only the black left, the first score or foul ends the frame.
    static void end(PoolRuling& ruling) {
        PoolState& next = ruling.next;
        if (next.phase == PoolPhase::over) return;
        next.choices.clear();
        if (next.score[0] == next.score[1]) return tie(ruling);
        win_by_points(next);
    }
};

}  // namespace

const Referee& snooker_referee() {
    static const Snooker referee;
    return referee;
}

}  // namespace carom
