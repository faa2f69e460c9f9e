#include "game/pool/pool.h"

#include <algorithm>

#include "game/digest.h"
#include "game/pool/shot_record.h"
#include "game/pool/table_places.h"
#include "game/referees/referee.h"
#include "level/scene/games.h"
#include "level/scene/racking.h"
#include "physics/world/random.h"

namespace carom {
namespace {

// Adds a ball like the scene's ball `like`, at rest at `place`.
BallId put_ball(const Scene& scene, World& world, BallId like, Vec2 place) {
    return add_ball(world, spec_at_rest(scene.world, *index_of(scene.world, like), place));
}

BallId first_id(const Scene& scene, int ball) {
    return ball == cue_ball ? scene.pool.cue->ball
                            : rack_of(scene).balls[static_cast<std::size_t>(ball - 1)];
}

void put_back(const Scene& scene, World& world, PoolPlay& play, int ball) {
    const BallId like = first_id(scene, ball);
    const double radius = scene.world.balls().radius[*index_of(scene.world, like)];
    const Rack& rack = rack_of(scene);
    const Vec2 spot = ball == cue_ball ? free_place(world, head_spot(scene), -rack.toward, radius)
                                       : free_place(world, rack.foot, rack.toward, radius);
    play.balls[static_cast<std::size_t>(ball)] = put_ball(scene, world, like, spot);
}

void rack_next(const Scene& scene, World& world, PoolPlay& play) {
    rack_frame(scene, world, play, play.racks + 1);
}

void carry_out(const Scene& scene, World& world, PoolPlay& play, const PoolRuling& ruling) {
    play.rules = ruling.next;
    play.last_foul = ruling.foul;
    play.call = {};
    if (play.rules.winner) ++play.frames[static_cast<std::size_t>(*play.rules.winner)];
    if (ruling.rerack) return rack_next(scene, world, play);
    for (const int ball : ruling.respot)
        put_back(scene, world, play, ball);
    if (!play.balls[cue_ball] && play.rules.phase != PoolPhase::over)
        put_back(scene, world, play, cue_ball);
}

void run_out_of_time(const Scene& scene, World& world, PoolPlay& play) {
    if (play.rules.phase != PoolPhase::choosing) {
        play.shooter = play.rules.player;
        play.shot = {};
    }
    carry_out(scene, world, play, judge_time(play.rules));
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

std::uint64_t digest_of(std::uint64_t start, const PoolPlay& play) {
    Digest digest(start);
    const auto add = [&digest](auto value) {
        digest.add(static_cast<std::uint64_t>(static_cast<std::int64_t>(value)));
    };
    const auto add_shot = [&](const PoolShot& shot) {
        add(shot.first_hit.value_or(-1));
        add(shot.rail_after_hit);
        add(shot.railed);
        add(shot.pocketed.size());
        for (const PoolShot::Pocketed& pocketed : shot.pocketed) {
            add(pocketed.ball);
            add(pocketed.pocket);
        }
    };
    const PoolState& rules = play.rules;
    add(rules.referee->id());
    add(rules.options.nine_on_break_wins);
    add(rules.options.fouls_that_lose);
    add(rules.phase);
    add(rules.player);
    add(rules.down);
    add(rules.group ? static_cast<int>(*rules.group) : -1);
    add(rules.in_hand);
    add(rules.may_push_out);
    add(rules.fouls[0]);
    add(rules.fouls[1]);
    add(rules.choices.size());
    for (const PoolChoice choice : rules.choices)
        add(choice);
    add(rules.winner.value_or(-1));
    for (const std::optional<BallId>& ball : play.balls)
        add(ball ? static_cast<std::int64_t>(number(*ball)) : -1);
    add(play.call.kind);
    add(play.call.ball);
    add(play.call.pocket);
    add(play.is_shooting);
    add_shot(play.shot);
    add(play.shooter.value_or(-1));
    add(play.last_foul);
    add(play.shots);
    add(play.breaker);
    add(play.frames[0]);
    add(play.frames[1]);
    if (play.race > 0) add(play.race);
    // Later members count only where a game uses them, so that older recordings keep their marks.
    if (play.shot.hit_behind_string) add(1);
    if (play.has_crossed && rules.in_hand == CueInHand::behind_head_string) add(2);
    for (const PoolPlay::Frozen& frozen : play.frozen) {
        add(frozen.ball);
        add(number(frozen.edge));
    }
    if (rules.options.stalemate > 0) {
        add(rules.options.stalemate);
        add(rules.breaker);
        add(rules.idle_shots);
    }
    if (play.winner_breaks) add(3);
    if (play.racks > 0) add(play.racks);
    return digest.value();
}

std::size_t bytes_of(const PoolPlay& play) {
    return play.frozen.capacity() * sizeof(PoolPlay::Frozen) +
           play.shot.pocketed.capacity() * sizeof(PoolShot::Pocketed) +
           play.rules.choices.capacity() * sizeof(PoolChoice);
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
                             .stalemate = rules.stalemate});
    play.winner_breaks = rules.winner_breaks;
    const int count = static_cast<int>(rack_of(scene).balls.size());
    for (int ball = 0; ball <= count; ++ball)
        play.balls[static_cast<std::size_t>(ball)] = first_id(scene, ball);
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
    carry_out(scene, world, play, judge(play.rules, play.call, play.shot));
}

void make_choice(const Scene& scene, World& world, PoolPlay& play, PoolChoice choice) {
    carry_out(scene, world, play, choose(play.rules, choice));
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
    for (int ball = 0; ball <= static_cast<int>(rack.balls.size()); ++ball) {
        const BallId like = first_id(scene, ball);
        const std::size_t first = *index_of(scene.world, like);
        Vec2 place = scene.world.balls().position[first];
        if (ball != cue_ball) {
            const RackedBall& at = racked_balls[static_cast<std::size_t>(ball - 1)];
            const double radius = scene.world.balls().radius[first];
            place = rack.foot + at.shift + at.grid * (2.0 * radius + at.gap);
        }
        play.balls[static_cast<std::size_t>(ball)] = put_ball(scene, world, like, place);
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
    play.last_foul = PoolFoul::none;
    rack_next(scene, world, play);
}

}  // namespace carom
