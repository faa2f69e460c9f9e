#include "game/referees/pool_rules.h"

#include <algorithm>
#include <bit>

namespace carom {
namespace {

constexpr std::uint32_t bit(int ball) {
    return std::uint32_t{1} << ball;
}

constexpr std::uint32_t solids = 0x00feu;
constexpr std::uint32_t stripes = 0xfe00u;
constexpr int eight = 8;
constexpr int nine = 9;
constexpr int enough_railed = 4;

bool fell(const PoolShot& shot, int ball) {
    return std::ranges::any_of(shot.pocketed, [ball](const auto& p) { return p.ball == ball; });
}

std::uint32_t object_balls_in(const PoolShot& shot) {
    std::uint32_t balls = 0;
    for (const PoolShot::Pocketed& pocketed : shot.pocketed)
        if (pocketed.ball != cue_ball) balls |= bit(pocketed.ball);
    return balls;
}

std::uint32_t balls_of(PoolGroup group) {
    return group == PoolGroup::solids ? solids : stripes;
}

PoolGroup other_group(PoolGroup group) {
    return group == PoolGroup::solids ? PoolGroup::stripes : PoolGroup::solids;
}

bool is_open_break(const PoolShot& shot) {
    return object_balls_in(shot) != 0 ||
           std::popcount(shot.railed & ~bit(cue_ball)) >= enough_railed;
}

PoolFoul foul_in_play(const PoolState& state, const PoolShot& shot) {
    if (fell(shot, cue_ball)) return PoolFoul::scratch;
    if (!shot.first_hit) return PoolFoul::no_hit;
    if (!may_hit_first(state, *shot.first_hit)) return PoolFoul::wrong_ball;
    if (object_balls_in(shot) == 0 && !shot.rail_after_hit) return PoolFoul::no_rail;
    return PoolFoul::none;
}

void pass_turn(PoolState& state) {
    state.player = 1 - state.player;
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

// The ball comes back, though it fell.
void spot(PoolRuling& ruling, int ball) {
    ruling.respot.push_back(ball);
    ruling.next.down &= ~bit(ball);
}

// 9-ball: one more foul in a row, and whether it loses the frame.
bool counts_to_loss(PoolState& state, int player) {
    int& fouls = state.fouls[static_cast<std::size_t>(player)];
    ++fouls;
    const int most = state.options.fouls_that_lose;
    return most > 0 && fouls >= most;
}

PoolRuling judge_eight_ball_break(PoolRuling ruling, const PoolShot& shot) {
    PoolState& next = ruling.next;
    const bool scratched = fell(shot, cue_ball);
    const bool eight_fell = fell(shot, eight);
    if (scratched) {
        ruling.foul = PoolFoul::scratch;
        pass_turn(next);
        next.in_hand = CueInHand::behind_head_string;
    }
    if (eight_fell) {
        let_choose(next, {PoolChoice::spot_eight, PoolChoice::break_again});
    } else if (!is_open_break(shot)) {
        if (!scratched) pass_turn(next);
        let_choose(next, {PoolChoice::take_table, PoolChoice::break_again, PoolChoice::let_break});
    } else if (!scratched && object_balls_in(shot) == 0) {
        pass_turn(next);
    }
    return ruling;
}

PoolRuling judge_eight_ball(const PoolState& state, PoolRuling ruling, const PoolCall& call,
                            const PoolShot& shot) {
    PoolState& next = ruling.next;
    const int player = state.player;
    ruling.foul = foul_in_play(state, shot);
    const auto group = group_of_player(state, player);
    const bool calls_pot = call.kind == PoolCall::Kind::pot;
    const bool made = calls_pot && std::ranges::any_of(shot.pocketed, [&](const auto& p) {
                          return p.ball == call.ball && p.pocket == call.pocket;
                      });
    if (fell(shot, eight)) {
        const bool was_on_eight = group && (balls_of(*group) & ~state.down) == 0;
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
    const auto called_group = calls_pot ? group_of(call.ball) : std::nullopt;
    const bool goes_on = made && called_group && (!group || called_group == group);
    if (!goes_on) {
        pass_turn(next);
        return ruling;
    }
    if (!group) next.group = player == 0 ? *called_group : other_group(*called_group);
    return ruling;
}

PoolRuling judge_nine_ball(const PoolState& state, PoolRuling ruling, const PoolCall& call,
                           const PoolShot& shot) {
    PoolState& next = ruling.next;
    const int player = state.player;
    const bool is_break = state.phase == PoolPhase::breaking;
    const bool is_push = state.may_push_out && call.kind == PoolCall::Kind::push_out;
    next.may_push_out = false;
    if (is_push)
        ruling.foul = fell(shot, cue_ball) ? PoolFoul::scratch : PoolFoul::none;
    else
        ruling.foul = foul_in_play(state, shot);
    if (is_break && ruling.foul == PoolFoul::no_rail) ruling.foul = PoolFoul::weak_break;
    if (is_break && ruling.foul == PoolFoul::none && !is_open_break(shot))
        ruling.foul = PoolFoul::weak_break;
    const bool is_foul = ruling.foul != PoolFoul::none;
    const bool nine_fell = fell(shot, nine);
    const bool nine_counts =
        !is_foul && !is_push && (!is_break || state.options.nine_on_break_wins);
    if (nine_fell && nine_counts) {
        win(next, player);
        return ruling;
    }
    if (nine_fell) spot(ruling, nine);
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
    if (object_balls_in(shot) == 0) pass_turn(next);
    next.may_push_out = is_break;
    return ruling;
}

}  // namespace

std::optional<PoolGroup> group_of(int ball) {
    if (ball >= 1 && ball < eight) return PoolGroup::solids;
    if (ball > eight && ball <= 15) return PoolGroup::stripes;
    return std::nullopt;
}

PoolState begin_rack(PoolGame game, int breaker, const PoolOptions& options) {
    PoolState state;
    state.game = game;
    state.options = options;
    state.player = breaker;
    return state;
}

std::optional<PoolGroup> group_of_player(const PoolState& state, int player) {
    if (!state.group) return std::nullopt;
    return player == 0 ? *state.group : other_group(*state.group);
}

bool is_down(const PoolState& state, int ball) {
    return (state.down & bit(ball)) != 0;
}

int lowest_ball(const PoolState& state) {
    int ball = 1;
    while (ball < nine && is_down(state, ball))
        ++ball;
    return ball;
}

bool may_hit_first(const PoolState& state, int ball) {
    if (state.game == PoolGame::nine_ball) return ball == lowest_ball(state);
    if (state.phase == PoolPhase::breaking) return true;
    const auto group = group_of_player(state, state.player);
    if (!group) return ball != eight;
    if ((balls_of(*group) & ~state.down) == 0) return ball == eight;
    return group_of(ball) == group;
}

PoolRuling judge(const PoolState& state, const PoolCall& call, const PoolShot& shot) {
    PoolRuling ruling;
    ruling.next = state;
    ruling.next.phase = PoolPhase::playing;
    ruling.next.in_hand = CueInHand::no;
    ruling.next.down |= object_balls_in(shot);
    if (state.game == PoolGame::nine_ball) return judge_nine_ball(state, ruling, call, shot);
    if (state.phase == PoolPhase::breaking) return judge_eight_ball_break(ruling, shot);
    return judge_eight_ball(state, ruling, call, shot);
}

PoolRuling judge_time(const PoolState& state) {
    if (state.phase == PoolPhase::choosing) return choose(state, state.choices.front());
    PoolRuling ruling;
    ruling.foul = PoolFoul::time;
    ruling.next = state;
    PoolState& next = ruling.next;
    next.may_push_out = false;
    if (state.game == PoolGame::nine_ball && counts_to_loss(next, state.player)) {
        win(next, 1 - state.player);
        return ruling;
    }
    pass_turn(next);
    next.in_hand =
        state.phase == PoolPhase::breaking ? CueInHand::behind_head_string : CueInHand::anywhere;
    return ruling;
}

PoolRuling choose(const PoolState& state, PoolChoice choice) {
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
            next = begin_rack(state.game, breaker, state.options);
            break;
        }
    }
    return ruling;
}

}  // namespace carom
