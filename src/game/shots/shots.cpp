#include "game/shots/shots.h"

#include <algorithm>
#include <utility>

#include "game/digest.h"
#include "game/pool/pool.h"
#include "game/shots/shots_play.h"
#include "level/scene/racking.h"

namespace carom {
namespace {

using Verdict = ShotsState::Verdict;

// The player with the best score; none: two share it.
std::optional<std::uint32_t> best_player(const Scene& scene, const ShotsState& state) {
    const auto worth = [&](const ShotsState::Player& player) {
        return scene.rules.least_wins ? -player.score : player.score;
    };
    const auto best = std::ranges::max_element(state.players, {}, worth);
    if (std::ranges::count(state.players, worth(*best), worth) > 1) return std::nullopt;
    return static_cast<std::uint32_t>(best - state.players.begin());
}

void end_game(const Scene& scene, ShotsState& state) {
    const auto players = static_cast<std::uint32_t>(state.players.size());
    const std::uint32_t player = state.rules.player;
    state.is_over = true;
    state.is_in_hand = false;
    std::ranges::fill(state.rules.timer_ends, 0);
    if (state.verdict == Verdict::win)
        state.winner = player;
    else if (state.verdict == Verdict::end)
        state.winner = best_player(scene, state);
    else if (players > 1)
        state.winner = (player + 1) % players;
}

void begin_turn(ShotsPlay& play) {
    begin_scope(play.scene.rules, play.state.rules, RuleScope::turn);
    ++play.state.players[play.state.rules.player].innings;
    happen(play.rules(), RuleEvent::turn_begins);
}

// A cue ball that a pocket took returns to its start, unless there are others to strike.
void return_cue_ball(ShotsPlay& play) {
    if (play.state.struck && !play.state.balls[*play.state.struck]) play.state.struck.reset();
    if (!cue_balls_of(play.scene, play.state).empty()) return;
    const std::uint32_t cue = cue_of(play.scene, play.state);
    if (!play.state.balls[cue]) put(play, cue, start_of(play.scene, cue));
}

// Carries out what the rules have decided.
void conclude(ShotsPlay& play) {
    ShotsState& state = play.state;
    if (state.verdict > Verdict::turn) return end_game(play.scene, state);
    if (std::exchange(state.verdict, Verdict::none) == Verdict::turn) {
        state.rules.player = (state.rules.player + 1) % play.scene.rules.players;
        state.struck.reset();
        begin_turn(play);
        if (state.verdict > Verdict::turn) return end_game(play.scene, state);
        state.verdict = Verdict::none;
    }
    return_cue_ball(play);
}

void end_shot(ShotsPlay& play) {
    play.state.is_shooting = false;
    play.state.rested = 0;
    happen(play.rules(), RuleEvent::shot_ends);
    happen(play.rules(), RuleEvent::shot_judged);
    // Before the next turn begins, with which variables of a turn start again.
    note_goal(play.scene.rules, play.state.rules, play, play.state.goal);
    conclude(play);
}

void begin_shot(ShotsPlay& play) {
    ShotsState& state = play.state;
    state.is_shooting = true;
    state.is_in_hand = false;
    state.message.clear();
    state.is_foul = false;
    ++state.shots;
    state.goal.shots = state.shots;
    ++state.players[state.rules.player].shots;
    begin_scope(play.scene.rules, state.rules, RuleScope::shot);
    begin_shot_events(play);
    happen(play.rules(), RuleEvent::shot_begins);
}

ShotsState fresh(const Scene& scene) {
    ShotsState state;
    state.rules = begin_rules(scene.rules);
    state.players.resize(scene.rules.players);
    for (const BallId id : scene.world.balls().id)
        state.balls.emplace_back(id);
    return state;
}

// The places of the balls in game number `game`: racks are racked anew.
std::vector<Vec2> places_of(const Scene& scene, std::uint32_t game) {
    std::vector<Vec2> places = scene.world.balls().position;
    for (const Rack& rack : scene.pool.racks) {
        const auto racked_balls = racked({rack.layout, rack.toward, rack.gap, rack.seed}, game);
        for (std::size_t i = 0; i < rack.balls.size() && i < racked_balls.size(); ++i) {
            const std::size_t ball = *index_of(scene.world, rack.balls[i]);
            const double radius = scene.world.balls().radius[ball];
            places[ball] = rack.foot + racked_balls[i].shift +
                           racked_balls[i].grid * (2.0 * radius + rack.gap);
        }
    }
    return places;
}

void play_again(const Scene& scene, World& world, ShotsState& state) {
    for (const std::optional<BallId>& ball : state.balls)
        if (ball) remove_ball(world, *ball);
    const std::uint32_t game = state.games + 1;
    state = fresh(scene);
    state.games = game;
    state.goal.begun = world.tick();
    const std::vector<Vec2> places = places_of(scene, game);
    for (std::uint32_t ball = 0; ball < state.balls.size(); ++ball)
        state.balls[ball] = add_ball(world, spec_at_rest(scene.world, ball, places[ball]));
}

}  // namespace

std::optional<ShotsState> begin_shots(const Scene& scene) {
    if (!scene.rules.is_shots) return std::nullopt;
    return fresh(scene);
}

const Cue& cue_in_turn(const Scene& scene, const ShotsState& state) {
    const std::vector<Cue>& cues = scene.pool.cues;
    return cues[state.rules.player % cues.size()];
}

std::uint32_t cue_of(const Scene& scene, const ShotsState& state) {
    if (state.struck) return *state.struck;
    const auto number = [&](BallId ball) {
        return static_cast<std::uint32_t>(*index_of(scene.world, ball));
    };
    const Cue& cue = cue_in_turn(scene, state);
    for (const BallId ball : cue.balls)
        if (state.balls[number(ball)]) return number(ball);
    return number(cue.ball);
}

std::optional<BallId> cue_ball_of(const Scene& scene, const ShotsState& state) {
    return state.balls[cue_of(scene, state)];
}

std::vector<BallId> cue_balls_of(const Scene& scene, const ShotsState& state) {
    std::vector<BallId> there;
    for (const BallId ball : cue_in_turn(scene, state).balls)
        if (const auto& now = state.balls[*index_of(scene.world, ball)]) there.push_back(*now);
    return there;
}

void update_shots(const Scene& scene, World& world, ShotsState& state,
                  std::span<const Contact> contacts) {
    if (state.is_over) return;
    ShotsPlay play(scene, world, state);
    if (std::exchange(state.rules.game_is_new, false)) happen(play.rules(), RuleEvent::game_begins);
    if (std::exchange(state.rules.turn_is_new, false)) begin_turn(play);
    end_timers(play.rules());
    if (state.is_shooting) happen_in_tick(play, contacts);
    state.rested = state.is_shooting && is_at_rest(world) ? state.rested + 1 : 0;
    const double settled = scene.rules.settle * world.rate();
    if (state.rested > 0 && static_cast<double>(state.rested) >= settled)
        end_shot(play);
    else if (!state.is_shooting && state.verdict != Verdict::none)
        conclude(play);  // of a timer, between two shots
    note_goal(scene.rules, state.rules, play, state.goal);
}

void execute(const Scene& scene, World& world, ShotsState& state, const Command& command) {
    if (std::holds_alternative<command::RackAgain>(command)) return play_again(scene, world, state);
    execute(world, command);
    const auto* const strike = std::get_if<command::Strike>(&command);
    if (!strike) return;
    if (cue_in_turn(scene, state).balls.size() > 1) state.struck = number_of(state, strike->ball);
    ShotsPlay play(scene, world, state);
    begin_shot(play);
}

std::uint64_t digest_of(std::uint64_t start, const ShotsState& state) {
    Digest digest(start);
    const auto add = [&digest](auto value) {
        digest.add(static_cast<std::uint64_t>(static_cast<std::int64_t>(value)));
    };
    add_to(digest, state.rules);
    for (const ShotsState::Player& player : state.players) {
        add(player.score);
        add(player.innings);
        add(player.shots);
        add(player.fouls);
    }
    for (const std::optional<BallId>& ball : state.balls)
        add(ball ? static_cast<std::int64_t>(number(*ball)) : -1);
    add(state.shots);
    add(state.games);
    add(state.is_shooting);
    add(state.verdict);
    add(state.is_over);
    add(state.winner ? static_cast<std::int64_t>(*state.winner) : -1);
    add(state.is_in_hand);
    add(state.hand_place);
    for (const auto* meetings : {&state.met, &state.touching, &state.inside}) {
        add(meetings->size());
        for (const ShotsState::Meeting& meeting : *meetings) {
            add(meeting.what);
            add(meeting.a);
            add(meeting.b);
        }
    }
    if (state.struck) add(*state.struck);
    if (state.rested > 0) add(state.rested);
    add_to(digest, state.goal);
    return digest.value();
}

std::size_t bytes_of(const ShotsState& state) {
    const auto bytes_in = [](const auto& values) {
        return values.capacity() * sizeof(values.front());
    };
    return bytes_of(state.rules) + bytes_in(state.players) + bytes_in(state.balls) +
           bytes_in(state.met) + bytes_in(state.touching) + bytes_in(state.inside) +
           state.message.capacity();
}

}  // namespace carom
