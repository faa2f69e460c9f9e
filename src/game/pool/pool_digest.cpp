#include "game/digest.h"
#include "game/pool/pool.h"
#include "game/referees/referee.h"

// What fingerprints and snapshot sizes count of a game of pool.
namespace carom {
namespace {

void add_snooker(Digest& digest, const PoolPlay& play) {
    const SnookerState& snooker = play.rules.snooker;
    const auto add = [&digest](auto value) {
        digest.add(static_cast<std::uint64_t>(static_cast<std::int64_t>(value)));
    };
    for (const SnookerTurn& turn : {snooker.now, snooker.before}) {
        add(turn.on);
        add(turn.is_free);
        add(turn.is_snookered);
        add(turn.sees_one_full);
        add(turn.in_hand);
        add(turn.down);
    }
    add(snooker.misses);
    add(snooker.is_miss);
    add(snooker.is_tie);
    for (const PoolPlay::Lay& lay : play.lay) {
        add(lay.ball);
        digest.add(lay.place.x);
        digest.add(lay.place.y);
    }
}

auto adding_to(Digest& digest) {
    return [&digest](auto value) {
        digest.add(static_cast<std::uint64_t>(static_cast<std::int64_t>(value)));
    };
}

void add_shot(Digest& digest, const PoolShot& shot) {
    const auto add = adding_to(digest);
    add(shot.first_hit.value_or(-1));
    add(shot.rail_after_hit);
    add(shot.railed);
    add(shot.pocketed.size());
    for (const PoolShot::Pocketed& pocketed : shot.pocketed) {
        add(pocketed.ball);
        add(pocketed.pocket);
    }
}

constexpr std::size_t usual_balls = 16;

// Members that came later count only where a game uses them, so that older recordings keep their
// fingerprints.
void add_later(Digest& digest, const PoolPlay& play) {
    const auto add = adding_to(digest);
    const PoolState& rules = play.rules;
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
    for (std::size_t ball = usual_balls; ball < play.balls.size(); ++ball)
        if (play.balls[ball]) {
            add(ball);
            add(number(*play.balls[ball]));
        }
    if (rules.score != std::array<int, 2>{} || rules.run != 0 || rules.waiting != 0) {
        add(rules.score[0]);
        add(rules.score[1]);
        add(rules.run);
        add(rules.waiting);
    }
    if (play.last_penalty != 0) add(play.last_penalty);
}

}  // namespace

std::uint64_t digest_of(std::uint64_t start, const PoolPlay& play) {
    Digest digest(start);
    const auto add = adding_to(digest);
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
    for (std::size_t ball = 0; ball < usual_balls; ++ball)
        add(play.balls[ball] ? static_cast<std::int64_t>(number(*play.balls[ball])) : -1);
    add(play.call.kind);
    add(play.call.ball);
    add(play.call.pocket);
    add(play.is_shooting);
    add_shot(digest, play.shot);
    add(play.shooter.value_or(-1));
    add(play.last_foul);
    add(play.shots);
    add(play.breaker);
    add(play.frames[0]);
    add(play.frames[1]);
    if (play.race > 0) add(play.race);
    add_later(digest, play);
    if (rules.referee->needs_sight()) add_snooker(digest, play);
    return digest.value();
}

std::size_t bytes_of(const PoolPlay& play) {
    return play.frozen.capacity() * sizeof(PoolPlay::Frozen) +
           play.lay.capacity() * sizeof(PoolPlay::Lay) +
           play.shot.pocketed.capacity() * sizeof(PoolShot::Pocketed) +
           play.rules.choices.capacity() * sizeof(PoolChoice);
}

}  // namespace carom
