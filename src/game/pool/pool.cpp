#include "game/pool/pool.h"

#include <algorithm>
#include <utility>

#include "game/pool/shot_record.h"
#include "game/pool/sight.h"
#include "game/pool/spotting.h"
#include "game/pool/table_places.h"
#include "game/referees/referee.h"
#include "level/scene/games.h"
#include "level/scene/racking.h"
#include "physics/world/random.h"

namespace carom {
namespace {

BallId put_ball(const Scene& scene, World& world, int ball, Vec2 place) {
    const std::size_t like = *index_of(scene.world, first_ball(scene, ball));
    return add_ball(world, spec_at_rest(scene.world, like, place));
}

void rack_next(const Scene& scene, World& world, PoolPlay& play) {
    rack_frame(scene, world, play, play.racks + 1);
}

// Pre: play.rules is the state after the ruling.
void set_balls(const Scene& scene, World& world, PoolPlay& play, const PoolRuling& ruling) {
    if (ruling.rerack) return rack_next(scene, world, play);
    if (ruling.put_back) return put_back(scene, world, play);
    if (ruling.rack_rest) rack_rest(scene, world, play);
    for (const int ball : ruling.respot)
        put_on_spot(scene, world, play, ball);
    if (play.rules.phase == PoolPhase::over) return;
    const auto& cue = play.balls[cue_ball];
    const bool in_d = play.rules.in_hand == CueInHand::in_d;
    if (!cue || (in_d && !is_in_hand_area(scene, CueInHand::in_d,
                                          world.balls().position[*index_of(world, *cue)])))
        put_on_spot(scene, world, play, cue_ball);
}

// Pre: play.rules is the state before the ruling.
void carry_out(const Scene& scene, World& world, PoolPlay& play, PoolRuling ruling,
               bool is_of_shot) {
    const PoolState before = std::exchange(play.rules, ruling.next);
    set_balls(scene, world, play, ruling);
    const Referee& referee = *before.referee;
    if (is_of_shot && referee.needs_sight()) {
        ruling.next = play.rules;
        const bool has_called = play.call.kind == PoolCall::Kind::pot;
        const auto named = has_called ? std::optional(play.call.ball) : play.shot.first_hit;
        referee.see(ruling, before, sight_of(scene, world, play, play.rules, named));
        play.rules = ruling.next;
    }
    if (ruling.toss)
        play.rules.player = static_cast<int>(random_bits(world.seed(), RandomStream::level,
                                                         number(scene.pool.cue->ball), play.shots) &
                                             1u);
    play.last_foul = ruling.foul;
    play.last_penalty = ruling.penalty;
    play.call = {};
    if (play.rules.winner) ++play.frames[static_cast<std::size_t>(*play.rules.winner)];
}

void decide(PoolPlay& play, std::optional<PoolChoice> choice) {
    play.decision = {choice, play.last_foul, play.last_penalty, is_miss(play.rules)};
}

void run_out_of_time(const Scene& scene, World& world, PoolPlay& play) {
    if (play.rules.phase != PoolPhase::choosing) {
        play.shooter = play.rules.player;
        play.shot = {};
        play.decision.reset();
    } else {
        decide(play, play.rules.choices.front());
    }
    carry_out(scene, world, play, judge_time(play.rules), false);
}

}  // namespace

void execute(const Scene& scene, World& world, PoolPlay& play, const Command& command) {
    if (const auto* call = std::get_if<command::CallShot>(&command)) {
        play.call = call->call;
    } else if (const auto* decide = std::get_if<command::Decide>(&command)) {
        make_choice(scene, world, play, decide->choice);
    } else if (std::holds_alternative<command::RackAgain>(command)) {
        rack_again(scene, world, play);
    } else if (std::holds_alternative<command::TimeOut>(command)) {
        run_out_of_time(scene, world, play);
    } else if (std::holds_alternative<command::Concede>(command)) {
        concede_frame(scene, world, play);
    } else {
        execute(world, command);
        if (std::holds_alternative<command::Strike>(command)) begin_shot(world, play);
    }
}

bool is_at_rest(const World& world) {
    const auto moves = [](Vec2 v) { return !(v == Vec2{}); };
    return std::ranges::none_of(world.balls().velocity, moves) &&
           std::ranges::none_of(world.balls().roll, moves);
}

std::optional<int> match_winner(const PoolPlay& play) {
    for (const int player : {0, 1})
        if (play.race > 0 && play.frames[static_cast<std::size_t>(player)] >= play.race)
            return player;
    return std::nullopt;
}

bool is_awaited(const PoolPlay& play) {
    return !play.is_shooting && play.rules.phase != PoolPhase::over;
}

std::optional<int> number_of(const PoolPlay& play, BallId ball) {
    const auto found = std::ranges::find(play.balls, std::optional(ball));
    if (found == play.balls.end()) return std::nullopt;
    return static_cast<int>(found - play.balls.begin());
}

std::optional<PoolPlay> begin_pool(const Scene& scene, int breaker) {
    const Referee* referee = referee_of(scene.game);
    if (!referee) return std::nullopt;
    PoolPlay play;
    const PoolRules& rules = scene.pool.rules;
    if (rules.is_tossed)
        breaker = static_cast<int>(
            random_bits(scene.world.seed(), RandomStream::level, number(scene.pool.cue->ball), 0) &
            1u);
    play.breaker = breaker;
    play.rules = begin_rack(*referee, breaker,
                            {.nine_on_break_wins = rules.nine_on_break_wins,
                             .fouls_that_lose = rules.fouls_that_lose,
                             .points = rules.points,
                             .foot_pockets = foot_pockets(scene),
                             .stalemate = rules.stalemate});
    play.winner_breaks = rules.winner_breaks;
    for (int ball = 0; ball <= object_balls(scene); ++ball)
        play.balls[static_cast<std::size_t>(ball)] = first_ball(scene, ball);
    play.race = scene.pool.race;
    return play;
}

void update_pool(const Scene& scene, World& world, PoolPlay& play,
                 std::span<const Contact> contacts) {
    if (!play.is_shooting) return;
    record_tick(scene, world, play, contacts);
    if (!is_at_rest(world)) return;
    play.is_shooting = false;
    play.frozen.clear();
    play.called = play.call;
    carry_out(scene, world, play, judge(play.rules, play.call, play.shot), true);
}

void make_choice(const Scene& scene, World& world, PoolPlay& play, PoolChoice choice) {
    decide(play, choice);
    carry_out(scene, world, play, choose(play.rules, choice), false);
}

void concede_frame(const Scene& scene, World& world, PoolPlay& play) {
    decide(play, std::nullopt);
    carry_out(scene, world, play, concede(play.rules), false);
}

void rack_frame(const Scene& scene, World& world, PoolPlay& play, std::uint32_t frame) {
    play.racks = frame;
    for (std::optional<BallId>& ball : play.balls) {
        if (ball) remove_ball(world, *ball);
        ball.reset();
    }
    const Rack& rack = rack_of(scene);
    const std::vector<RackedBall> racked_balls =
        racked({rack.layout, rack.toward, rack.gap, rack.seed}, frame);
    const auto in_rack = static_cast<int>(rack.balls.size());
    for (int ball = 0; ball <= object_balls(scene); ++ball) {
        Vec2 place = home_of(scene, ball);
        if (ball != cue_ball && ball <= in_rack) {
            const RackedBall& at = racked_balls[static_cast<std::size_t>(ball - 1)];
            const double radius =
                scene.world.balls().radius[*index_of(scene.world, first_ball(scene, ball))];
            place = rack.foot + at.shift + at.grid * (2.0 * radius + at.gap);
        }
        play.balls[static_cast<std::size_t>(ball)] = put_ball(scene, world, ball, place);
    }
}

void rack_again(const Scene& scene, World& world, PoolPlay& play) {
    if (match_winner(play)) play.frames = {};
    if (play.rules.phase == PoolPhase::over)
        play.breaker =
            play.winner_breaks && play.rules.winner ? *play.rules.winner : 1 - play.breaker;
    play.rules = begin_rack(*play.rules.referee, play.breaker, play.rules.options);
    play.call = {};
    play.shot = {};
    play.shooter.reset();
    play.decision.reset();
    play.last_foul = PoolFoul::none;
    rack_next(scene, world, play);
}

}  // namespace carom
