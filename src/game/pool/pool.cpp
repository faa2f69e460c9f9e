#include "game/pool/pool.h"

#include <algorithm>
#include <iterator>

#include "game/digest.h"
#include "game/referees/referee.h"
#include "geometry/closest.h"
#include "geometry/impact.h"
#include "level/scene/games.h"
#include "physics/world/random.h"

namespace carom {

const Rack& rack_of(const Scene& scene) {
    return *std::ranges::find(scene.pool.racks, game_named(scene.game)->rack, &Rack::layout);
}

namespace {

// Adds a ball like the scene's ball `like`, at rest at `place`.
BallId put_ball(const Scene& scene, World& world, BallId like, Vec2 place) {
    return add_ball(world, spec_at_rest(scene.world, *index_of(scene.world, like), place));
}

BallId first_id(const Scene& scene, int ball) {
    return ball == cue_ball ? scene.pool.cue->ball
                            : rack_of(scene).balls[static_cast<std::size_t>(ball - 1)];
}

bool is_free(const World& world, Vec2 place, double radius) {
    for (std::size_t i = 0; i < world.balls().size(); ++i)
        if (length(world.balls().position[i] - place) < radius + world.balls().radius[i])
            return false;
    return true;
}

// The nearest free position from `spot` along `way`; if there is none, in the opposite direction.
Vec2 free_place(const World& world, Vec2 spot, Vec2 way, double radius) {
    constexpr int most_steps = 400;
    const double step = 0.05 * radius;
    for (const double sign : {1.0, -1.0})
        for (int i = 0; i < most_steps; ++i) {
            const Vec2 place = spot + way * (sign * step * i);
            if (is_free(world, place, radius)) return place;
        }
    return spot;
}

void put_back(const Scene& scene, World& world, PoolPlay& play, int ball) {
    const BallId like = first_id(scene, ball);
    const double radius = scene.world.balls().radius[*index_of(scene.world, like)];
    const Rack& rack = rack_of(scene);
    const Vec2 spot = ball == cue_ball ? free_place(world, head_spot(scene), -rack.toward, radius)
                                       : free_place(world, rack.foot, rack.toward, radius);
    play.balls[static_cast<std::size_t>(ball)] = put_ball(scene, world, like, spot);
}

void rack_anew(const Scene& scene, World& world, PoolPlay& play) {
    for (std::optional<BallId>& ball : play.balls) {
        if (ball) remove_ball(world, *ball);
        ball.reset();
    }
    const int count = static_cast<int>(rack_of(scene).balls.size());
    for (int ball = 0; ball <= count; ++ball) {
        const BallId like = first_id(scene, ball);
        const Vec2 place = scene.world.balls().position[*index_of(scene.world, like)];
        play.balls[static_cast<std::size_t>(ball)] = put_ball(scene, world, like, place);
    }
}

void carry_out(const Scene& scene, World& world, PoolPlay& play, const PoolRuling& ruling) {
    play.rules = ruling.next;
    play.last_foul = ruling.foul;
    play.call = {};
    if (play.rules.winner) ++play.frames[static_cast<std::size_t>(*play.rules.winner)];
    if (ruling.rerack) return rack_anew(scene, world, play);
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

// Whether a place is beyond the head string, seen from its head.
bool is_beyond_string(const Scene& scene, Vec2 place) {
    return dot(place - head_spot(scene), rack_of(scene).toward) >= 0.0;
}

bool touches(const World& world, std::size_t ball, std::size_t edge) {
    constexpr double hair = 1e-4;  // radii
    const double radius = world.balls().radius[ball];
    return separation({world.balls().position[ball], radius}, world.capsules().shape[edge]) <=
           hair * radius;
}

// The balls that lie at an edge when a shot begins.
std::vector<PoolPlay::Frozen> find_frozen(const World& world, const PoolPlay& play) {
    std::vector<PoolPlay::Frozen> frozen;
    for (std::size_t n = 0; n < play.balls.size(); ++n) {
        const auto ball = play.balls[n] ? index_of(world, *play.balls[n]) : std::nullopt;
        for (std::size_t edge = 0; ball && edge < world.capsules().size(); ++edge)
            if (touches(world, *ball, edge))
                frozen.push_back({static_cast<int>(n), world.capsules().id[edge]});
    }
    return frozen;
}

// Forgets those that have left their edges, at the end of a tick.
void thaw(const World& world, PoolPlay& play) {
    std::erase_if(play.frozen, [&](const PoolPlay::Frozen& frozen) {
        const auto& id = play.balls[static_cast<std::size_t>(frozen.ball)];
        const auto ball = id ? index_of(world, *id) : std::nullopt;
        const auto edge = index_of(world, frozen.edge);
        return !ball || !edge || !touches(world, *ball, *edge);
    });
}

void note_first_hit(const Scene& scene, const World& world, PoolPlay& play, const Contact& contact,
                    int ball) {
    play.shot.first_hit = ball;
    // The normal points from ball b to ball a.
    const bool cue_is_a = play.balls[cue_ball] == BallId{contact.a};
    const Vec2 towards = cue_is_a ? -contact.normal : contact.normal;
    const auto centre = [&](int number, double side) {
        const auto& id = play.balls[static_cast<std::size_t>(number)];
        const auto index = id ? index_of(world, *id) : std::nullopt;
        return contact.point + towards * (side * (index ? world.balls().radius[*index] : 0.0));
    };
    const bool has_crossed = play.has_crossed || is_beyond_string(scene, centre(cue_ball, -1.0));
    play.shot.hit_behind_string = !has_crossed && !is_beyond_string(scene, centre(ball, 1.0));
}

void note_contacts(const Scene& scene, const World& world, PoolPlay& play,
                   std::span<const Contact> contacts) {
    for (const Contact& contact : contacts) {
        const auto a = number_of(play, BallId{contact.a});
        if (contact.kind == ContactKind::ball_ball) {
            const auto b = number_of(play, BallId{contact.b});
            if (!a || !b || play.shot.first_hit) continue;
            if (*a == cue_ball || *b == cue_ball)
                note_first_hit(scene, world, play, contact, *a == cue_ball ? *b : *a);
            continue;
        }
        if (!a) continue;
        if (std::ranges::count(play.frozen, PoolPlay::Frozen{*a, world.capsules().id[contact.b]}) >
            0)
            continue;
        if (play.shot.first_hit) play.shot.rail_after_hit = true;
        play.shot.railed |= std::uint32_t{1} << *a;
    }
}

void note_pocketed(const Scene& scene, const World& world, PoolPlay& play) {
    auto removal = world.removed().end();
    while (removal != world.removed().begin() && std::prev(removal)->tick == world.tick())
        --removal;
    for (; removal != world.removed().end(); ++removal) {
        const auto ball = number_of(play, removal->id);
        if (!ball || removal->zone < 0) continue;
        const auto pocket =
            std::ranges::find(scene.pool.pockets, static_cast<std::uint32_t>(removal->zone));
        play.shot.pocketed.push_back(
            {*ball, static_cast<int>(pocket - scene.pool.pockets.begin())});
        play.balls[static_cast<std::size_t>(*ball)].reset();
    }
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

bool is_on_table(const Scene& scene, const World& world, Vec2 place, double radius) {
    const Vec2 from = head_spot(scene);
    const Disc ball{from, radius};
    for (const Capsule& edge : world.capsules().shape)
        if (first_impact(ball, place - from, edge, 1.0)) return false;
    return std::ranges::none_of(scene.pool.pockets, [&](std::uint32_t pocket) {
        const Capsule& shape = scene.world.zones()[pocket].shape;
        return length(place - shape.start) < shape.radius;
    });
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

Vec2 head_spot(const Scene& scene) {
    // The head spot is as far from the centre of the table as the foot spot.
    Vec2 middle;
    for (const std::uint32_t pocket : scene.pool.pockets)
        middle += scene.world.zones()[pocket].shape.start;
    middle = middle / static_cast<double>(scene.pool.pockets.size());
    return middle * 2.0 - rack_of(scene).foot;
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

void begin_shot(const World& world, PoolPlay& play) {
    play.is_shooting = true;
    play.has_crossed = false;
    play.frozen = find_frozen(world, play);
    play.shooter = play.rules.player;
    play.shot = {};
    ++play.shots;
}

void update_pool(const Scene& scene, World& world, PoolPlay& play,
                 std::span<const Contact> contacts) {
    if (!play.is_shooting) return;
    note_contacts(scene, world, play, contacts);
    note_pocketed(scene, world, play);
    thaw(world, play);
    const auto cue = play.balls[cue_ball] ? index_of(world, *play.balls[cue_ball]) : std::nullopt;
    if (cue && is_beyond_string(scene, world.balls().position[*cue])) play.has_crossed = true;
    if (!is_at_rest(world)) return;
    play.is_shooting = false;
    play.frozen.clear();
    carry_out(scene, world, play, judge(play.rules, play.call, play.shot));
}

void make_choice(const Scene& scene, World& world, PoolPlay& play, PoolChoice choice) {
    carry_out(scene, world, play, choose(play.rules, choice));
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
    rack_anew(scene, world, play);
}

}  // namespace carom
