#include "game/referees/referee.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "game/referees/ruling.h"

namespace carom {

// Each is defined in a file of its own.
const Referee& eight_ball_referee();
const Referee& nine_ball_referee();
const Referee& ten_ball_referee();
const Referee& straight_pool_referee();
const Referee& one_pocket_referee();
const Referee& snooker_referee();

std::span<const Referee* const> referees() {
    static const std::array all{&eight_ball_referee(), &nine_ball_referee(),
                                &ten_ball_referee(),   &straight_pool_referee(),
                                &one_pocket_referee(), &snooker_referee()};
    return all;
}

const Referee* referee_of(std::string_view game) {
    const auto found = std::ranges::find(referees(), game, &Referee::game);
    return found == referees().end() ? nullptr : *found;
}

void Referee::begin(PoolState&) const {}

std::optional<int> Referee::pocket_of(const PoolState&, int) const {
    return std::nullopt;
}

bool Referee::may_pocket(const PoolState& state, int pocket) const {
    const auto only = pocket_of(state, state.player);
    return !only || *only == pocket;
}

bool Referee::needs_sight() const {
    return false;
}

void Referee::see(PoolRuling&, const PoolState&, const PoolSight&) const {}

PoolRuling Referee::judge_time(const PoolState& state) const {
    PoolRuling ruling;
    ruling.foul = PoolFoul::time;
    ruling.next = state;
    ruling.next.may_push_out = false;
    ruling.next.in_hand =
        state.phase == PoolPhase::breaking ? CueInHand::behind_head_string : CueInHand::anywhere;
    pass_turn(ruling.next);
    return ruling;
}

PoolRuling Referee::choose(const PoolState& state, PoolChoice choice) const {
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
        case PoolChoice::let_break:
            ruling.rerack = true;
            next = rack_again(state,
                              choice == PoolChoice::break_again ? state.player : 1 - state.player);
            break;
        case PoolChoice::replace:
            ruling.put_back = true;
            pass_turn(next);
            break;
    }
    return ruling;
}

PoolState Referee::rack_again(const PoolState& state, int breaker) const {
    return begin_rack(*this, breaker, state.options);
}

bool Referee::is_warned(const PoolState& state) const {
    const int most = state.options.fouls_that_lose;
    return most > 1 && state.fouls[static_cast<std::size_t>(state.player)] == most - 1;
}

bool Referee::has_own_spot(int) const {
    return false;
}

bool Referee::may_put_back() const {
    return false;
}

std::string Referee::ball_name(int ball) const {
    return fmt::format("the {}", ball);
}

bool Referee::has_numbers() const {
    return true;
}

bool Referee::calls_pocket() const {
    return true;
}

std::string_view Referee::declarations() const {
    return "";
}

std::string_view Referee::warning_text() const {
    return "the next foul loses";
}

std::string_view Referee::reason_text(const PoolState&, const PoolCall&, const PoolShot&,
                                      int) const {
    return "";
}

std::string Referee::score_text(const PoolState&) const {
    return "";
}

double Referee::lead(const PoolState&) const {
    return 0.0;
}

bool Referee::breaks_hard() const {
    return true;
}

PoolState begin_rack(const Referee& referee, int breaker, const PoolOptions& options) {
    PoolState state;
    state.referee = &referee;
    state.options = options;
    state.player = state.breaker = breaker;
    referee.begin(state);
    return state;
}

bool is_down(const PoolState& state, int ball) {
    return (state.down & ball_bit(ball)) != 0;
}

bool may_hit_first(const PoolState& state, int ball) {
    return state.referee->may_hit_first(state, ball);
}

bool is_miss(const PoolState& state) {
    return may_choose(state, PoolChoice::replace);
}

bool may_call(const PoolState& state, PoolCall::Kind kind) {
    const bool is_to_shoot =
        state.phase == PoolPhase::breaking || state.phase == PoolPhase::playing;
    return is_to_shoot && state.referee->why_no_call(state, kind).empty();
}

PoolRuling judge(const PoolState& state, const PoolCall& call, const PoolShot& shot) {
    PoolRuling ruling = state.referee->judge(state, call, shot);
    if (state.options.stalemate > 0) {
        int& idle = ruling.next.idle_shots;
        idle = pocketed_object_balls(shot) == 0 ? idle + 1 : 0;
        if (idle >= state.options.stalemate && ruling.next.phase == PoolPhase::playing) {
            ruling.respot.clear();
            ruling.rerack = true;
            ruling.next = state.referee->rack_again(ruling.next, state.breaker);
        }
    }
    return ruling;
}

bool is_warned(const PoolState& state) {
    return state.referee->is_warned(state);
}

PoolRuling judge_time(const PoolState& state) {
    if (state.phase == PoolPhase::choosing) return choose(state, state.choices.front());
    return state.referee->judge_time(state);
}

PoolRuling concede(const PoolState& state) {
    PoolRuling ruling;
    ruling.next = state;
    ruling.next.choices.clear();
    win(ruling.next, 1 - state.player);
    return ruling;
}

PoolRuling choose(const PoolState& state, PoolChoice choice) {
    return state.referee->choose(state, choice);
}

}  // namespace carom
