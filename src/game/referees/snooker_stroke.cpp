#include "game/referees/snooker_stroke.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "game/referees/referee.h"

namespace carom::snooker {
namespace {

using On = SnookerTurn::On;

int colors_left(const PoolState& state) {
    int points = 0;
    for (int ball = yellow; ball <= black; ++ball)
        if (!is_down(state, ball)) points += value_of(ball);
    return points;
}

// The ball that the striker named, where the striker had to name one.
std::optional<int> named_ball(const PoolState& state, const PoolCall& call, const PoolShot& shot) {
    const SnookerTurn& now = state.snooker.now;
    if (now.on != On::color && !now.is_free) return std::nullopt;
    const std::optional<int> named =
        call.kind == PoolCall::Kind::pot ? std::optional(call.ball) : shot.first_hit;
    if (!named || (now.on == On::color && !is_color(*named))) return std::nullopt;
    return named;
}

bool is_fair_hit(const PoolState& state, const Task& task, int ball) {
    if (task.named && !is_on(state, *task.named)) return ball == *task.named;
    if (state.snooker.now.on == On::color) return task.named == std::optional(ball);
    return is_on(state, ball);
}

bool is_fair_pot(const PoolState& state, const Task& task, int ball) {
    if (state.snooker.now.on == On::color) return task.named == std::optional(ball);
    return is_on(state, ball) || task.named == std::optional(ball);
}

}  // namespace

int reds_left(const PoolState& state) {
    return std::popcount(fifteen_balls & ~state.down);
}

int lowest_color(const PoolState& state) {
    int ball = yellow;
    while (ball < black && is_down(state, ball))
        ++ball;
    return ball;
}

bool is_on(const PoolState& state, int ball) {
    switch (state.snooker.now.on) {
        case On::red:
            return is_red(ball);
        case On::color:
            return is_color(ball);
        case On::in_order:
            return ball == lowest_color(state);
    }
    return false;
}

int points_left(const PoolState& state) {
    const int reds = reds_left(state) + (state.snooker.now.on == On::color ? 1 : 0);
    const int from_reds = reds * value_of(black) + reds_left(state);
    return from_reds + colors_left(state);
}

bool needs_penalties(const PoolState& state) {
    return std::abs(state.score[0] - state.score[1]) > points_left(state);
}

Task task_of(const PoolState& state, const PoolCall& call, const PoolShot& shot) {
    const std::optional<int> named = named_ball(state, call, shot);
    switch (state.snooker.now.on) {
        case On::red:
            return {named, 1};
        case On::color:
            return {named, value_of(named.value_or(black))};
        case On::in_order:
            return {named, value_of(lowest_color(state))};
    }
    return {};
}

Offence offence_of(const PoolState& state, const Task& task, const PoolShot& shot) {
    Offence offence;
    const auto add = [&](PoolFoul foul, int value) {
        if (offence.foul == PoolFoul::none) offence.foul = foul;
        offence.penalty = std::max({offence.penalty, value, task.value, least_penalty});
    };
    if (!shot.first_hit)
        add(PoolFoul::no_hit, 0);
    else if (!is_fair_hit(state, task, *shot.first_hit))
        add(PoolFoul::wrong_ball, value_of(*shot.first_hit));
    if (is_pocketed(shot, cue_ball)) add(PoolFoul::scratch, 0);
    for (const PoolShot::Pocketed& each : shot.pocketed)
        if (each.ball != cue_ball && !is_fair_pot(state, task, each.ball))
            add(PoolFoul::wrong_pot, value_of(each.ball));
    return offence;
}

int points_of(const PoolState& state, const Task& task, const PoolShot& shot) {
    const std::uint32_t pocketed = pocketed_object_balls(shot);
    if (state.snooker.now.on != On::red) return pocketed == 0 ? 0 : task.value;
    return std::popcount(pocketed);
}

std::uint32_t returning(const PoolState& state, std::uint32_t pocketed) {
    const std::uint32_t colors = pocketed & all_colors;
    if (state.snooker.now.on != On::in_order) return colors;
    return colors & ~ball_bit(lowest_color(state));
}

}  // namespace carom::snooker
