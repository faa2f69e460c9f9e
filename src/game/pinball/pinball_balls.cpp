#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "game/pinball/pinball.h"
#include "game/pinball/pinball_players.h"
#include "game/pinball/pinball_table.h"
#include "game/rules/rules.h"
#include "physics/world/random.h"

// Which balls are in play: those that are served, locked and drained, and so when a ball and a game
// end.
namespace carom {
namespace {

using Phase = PinballState::Phase;

constexpr double launch_pause = 0.6;   // s from the serve of a ball to its automatic launch
constexpr double counting_time = 2.5;  // s that the bonus is shown
constexpr double lock_time = 0.5;  // s that a ball lies in a lock before it counts, and after it

void begin_ball(Pinball game) {
    PinballState& state = game.state;
    state.phase = Phase::playing;
    state.bonus = 0;
    state.multiplier = 1;
    state.is_launched = false;
    state.launch_at = 0;
    state.save_until = 0;
    state.is_tilted = false;
    state.warnings = 0;
    state.tilt_meter = 0.0;
    begin_scope(game.scene.rules, state.rules, RuleScope::turn);
    state.rules.turn_is_new = true;
    for (std::uint32_t i = 0; i < game.table().devices.size(); ++i)
        if (game.table().devices[i].kind == DeviceKind::kickback) set_lit(game, i, true);
}

void serve_next(Pinball game) {
    begin_ball(game);
    game.state.to_serve = 1;
    game.state.serves_itself = false;
}

// Between games no ball stays in a lock.
void remove_locked_balls(Pinball game) {
    World& world = game.world;
    for (std::size_t i = world.balls().size(); i-- > 0;) {
        const BallId ball = world.balls().id[i];
        if (is_captive(game.scene, ball)) continue;
        remove_ball(world, ball);
        ++game.state.removals_seen;  // so that the removal does not count as a drain
    }
    game.state.held.clear();
    game.state.lying.clear();
    game.state.locked.clear();
}

void end_game(Pinball game) {
    PinballState& state = game.state;
    state.phase = Phase::over;
    if (!state.parked.empty()) {
        const std::vector<std::int64_t> scores = scores_of(state);
        const auto winner = std::ranges::max_element(scores) - scores.begin();
        state.parked[state.rules.player].score = state.score;
        state.rules.player = static_cast<std::uint32_t>(winner);
        state.score = scores[static_cast<std::size_t>(winner)];
        return game.say(fmt::format("GAME OVER  PLAYER {} WINS", winner + 1), 3600.0);
    }
    // From the moment as well: the first game of each evening would else draw the same number.
    const auto drawn =
        random_bits(game.world.seed(), RandomStream::player, state.games, game.now()) % 10;
    const bool matches = static_cast<std::uint64_t>(state.score / 10 % 10) == drawn;
    game.say(fmt::format("GAME OVER  MATCH {}0{}", drawn, matches ? "  YOUR SCORE MATCHES" : ""),
             3600.0);
}

void end_ball(Pinball game) {
    PinballState& state = game.state;
    const std::int64_t counted =
        state.is_tilted ? 0 : state.bonus * state.multiplier * game.table().bonus;
    state.score += counted;
    game.say(counted > 0 ? fmt::format("BONUS {}", grouped(counted)) : "NO BONUS", counting_time);
    state.phase = Phase::counting;
    std::ranges::fill(state.rules.timer_ends, 0);
    state.phase_until = game.now() + game.ticks(counting_time);
}

// Brings PinballState::lying up to date with the visits of this tick.
void note_lying(Pinball game) {
    const auto group = [&](std::uint32_t device) { return game.table().devices[device].group; };
    std::vector<PinballState::Lying>& lying = game.state.lying;
    for (const PinballState::Visit& visit : game.state.visits) {
        if (game.table().devices[visit.device].kind != DeviceKind::lock) continue;
        const auto known = std::ranges::find_if(lying, [&](const PinballState::Lying& ball) {
            return ball.ball == visit.ball && group(ball.device) == group(visit.device);
        });
        if (known == lying.end()) {
            lying.push_back({visit.device, visit.ball, game.now(), game.now(), false});
        } else {
            known->device = visit.device;
            known->seen = game.now();
        }
    }
    std::erase_if(lying, [&](const PinballState::Lying& ball) {
        return game.now() > ball.seen + game.ticks(lock_time);
    });
}

}  // namespace

void update_locks(Pinball game) {
    if (!game.table().has_locks) return;
    PinballState& state = game.state;
    note_lying(game);
    std::vector<std::uint32_t> holding;
    state.locked.clear();
    for (const PinballState::Lying& ball : state.lying) {
        if (ball.seen < game.now() || game.now() < ball.since + game.ticks(lock_time)) continue;
        holding.push_back(ball.device);
        state.locked.push_back(ball.ball);
    }
    for (const PinballState::Held& held : state.held) {
        if (held.until != PinballState::keeps_until_released) continue;
        holding.push_back(held.device);
        state.locked.push_back(held.ball);
    }
    std::ranges::sort(state.locked);
    state.locked.erase(std::unique(state.locked.begin(), state.locked.end()), state.locked.end());
    for (PinballState::Lying& ball : state.lying) {
        const bool is_locked = std::ranges::binary_search(state.locked, ball.ball);
        if (is_locked && !std::exchange(ball.is_counted, true))
            apply_rules(game, ball.device, RuleEvent::enter);
    }
    for (std::uint32_t device = 0; device < game.table().devices.size(); ++device)
        if (game.table().devices[device].kind == DeviceKind::lock ||
            game.table().devices[device].keeps)
            set_lit(game, device, std::ranges::count(holding, device) > 0);
}

std::size_t all_balls(Pinball game) {
    return game.world.balls().size() - game.table().captives.size() + game.state.to_serve;
}

std::size_t balls_in_play(Pinball game) {
    return game.world.balls().size() - game.table().captives.size() - game.state.locked.size();
}

void wait_for_launch(Pinball game) {
    PinballState& state = game.state;
    if (!game.table().is_game || state.phase != Phase::playing || state.to_serve > 0 ||
        state.launch_at != 0 || balls_in_play(game) != 1 || !is_on_plunger(game.scene, game.world))
        return;
    const auto stand = [&](std::uint64_t& end) {
        if (end > game.now()) ++end;
    };
    stand(state.save_until);
    std::ranges::for_each(state.rules.timer_ends, stand);
    std::ranges::for_each(state.lit_until, stand);
}

void serve(Pinball game) {
    PinballState& state = game.state;
    const Balls& balls = game.scene.world.balls();
    if (state.to_serve == 0 || state.launch_at != 0 || balls.size() == 0) return;
    for (std::size_t i = 0; i < game.world.balls().size(); ++i) {
        const double reach = game.world.balls().radius[i] + balls.radius[0];
        if (distance(game.world.balls().position[i], balls.position[0]) < 1.5 * reach) return;
    }
    add_ball(game.world, spec_of(game.scene.world, 0));
    --state.to_serve;
    if (state.serves_itself) state.launch_at = game.now() + game.ticks(launch_pause);
}

void launch_tilted_ball(Pinball game) {
    PinballState& state = game.state;
    const bool waits = state.is_tilted && state.phase == Phase::playing && state.to_serve == 0 &&
                       state.launch_at == 0 && is_on_plunger(game.scene, game.world);
    if (waits) state.launch_at = game.now() + game.ticks(launch_pause);
}

void begin_game_again(Pinball game) {
    PinballState& state = game.state;
    ++state.games;
    state.goal = {.shots = 0, .begun = game.now(), .done = {}};
    state.score = 0;
    state.ball = 1;
    state.extra_balls = 0;
    state.rules = begin_rules(game.scene.rules);
    begin_players(state);
    for (std::uint32_t i = 0; i < game.table().devices.size(); ++i)
        set_lit(game, i, false);
    for (std::uint32_t i = 0; i < game.table().devices.size(); ++i)
        if (game.table().devices[i].kind == DeviceKind::droptarget) state.is_rising[i] = 1;
    remove_locked_balls(game);
    state.message.clear();
    state.extra_ball_is_untold = false;
    serve_next(game);
}

void count_drained(Pinball game) {
    PinballState& state = game.state;
    const std::uint64_t gone = game.world.ledger().removed.size() - state.removals_seen;
    for (std::uint64_t i = state.removals_seen; i < game.world.ledger().removed.size(); ++i) {
        const std::int32_t zone = game.world.ledger().removed[static_cast<std::size_t>(i)].zone;
        for (std::uint32_t d = 0; d < game.table().devices.size() && zone >= 0; ++d)
            if (game.table().devices[d].zone == static_cast<std::uint32_t>(zone))
                apply_rules(game, d, RuleEvent::enter);
    }
    state.removals_seen = game.world.ledger().removed.size();
    state.drained += gone;
    for (std::uint64_t i = 0; i < gone; ++i)
        apply_rules(game, RuleEvent::drain);
    if (!game.table().is_game || state.phase != Phase::playing) return;
    if (gone > 0 && game.now() <= state.save_until) {
        state.to_serve += static_cast<std::uint32_t>(gone);
        state.serves_itself = true;
        game.say("BALL SAVED", 2.0);
    }
    if (balls_in_play(game) > 0 || state.to_serve > 0) return;
    if (gone > 0 || state.locked.empty()) return end_ball(game);
    state.to_serve = 1;  // for the ball that has just been locked
    state.serves_itself = false;
}

void go_on_after_count(Pinball game) {
    PinballState& state = game.state;
    if (state.phase != Phase::counting || game.now() < state.phase_until) return;
    if (state.extra_balls > 0) {
        --state.extra_balls;
        game.say("SHOOT AGAIN", 2.0);
        serve_next(game);
    } else if (pass_to_next_player(game)) {
        serve_next(game);
    } else {
        end_game(game);
    }
}

}  // namespace carom
