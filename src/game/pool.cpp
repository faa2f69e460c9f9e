#include "game/pool.h"

#include <algorithm>
#include <iterator>

namespace carom {
namespace {

const Rack& rack_of(const Scene& scene) {
    const auto wanted = scene.game == "eightball" ? Rack::Shape::eight : Rack::Shape::nine;
    return *std::ranges::find(scene.pool.racks, wanted, &Rack::shape);
}

bool is_still(const World& world) {
    const auto moves = [](Vec2 v) { return !(v == Vec2{}); };
    return std::ranges::none_of(world.balls.velocity, moves) &&
           std::ranges::none_of(world.balls.roll, moves);
}

// As the scene's ball of that id, but there, and at rest.
BallId put_ball(const Scene& scene, World& world, BallId like, Vec2 place) {
    const Balls& balls = scene.world.balls;
    const std::size_t i = *index_of(scene.world, like);
    BallSpec spec;
    spec.kind = balls.kind[i];
    spec.position = place;
    spec.radius = balls.radius[i];
    spec.mass = 1.0 / balls.inverse_mass[i];
    if (!balls.restitution.empty()) spec.restitution = balls.restitution[i];
    return add_ball(world, spec);
}

BallId first_id(const Scene& scene, int ball) {
    return ball == cue_ball ? scene.pool.cue->ball
                            : rack_of(scene).balls[static_cast<std::size_t>(ball - 1)];
}

bool is_free(const World& world, Vec2 place, double radius) {
    for (std::size_t i = 0; i < world.balls.size(); ++i)
        if (length(world.balls.position[i] - place) < radius + world.balls.radius[i]) return false;
    return true;
}

// The nearest free place from `spot` on, along `way`; where there is none, before it.
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
    const double radius = scene.world.balls.radius[*index_of(scene.world, like)];
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
        const Vec2 place = scene.world.balls.position[*index_of(scene.world, like)];
        play.balls[static_cast<std::size_t>(ball)] = put_ball(scene, world, like, place);
    }
}

void carry_out(const Scene& scene, World& world, PoolPlay& play, const PoolRuling& ruling) {
    play.rules = ruling.next;
    play.last_foul = ruling.foul;
    play.call = {};
    if (ruling.rerack) return rack_anew(scene, world, play);
    for (const int ball : ruling.respot)
        put_back(scene, world, play, ball);
    if (!play.balls[cue_ball] && play.rules.phase != PoolPhase::over)
        put_back(scene, world, play, cue_ball);
}

void note_contacts(PoolPlay& play, std::span<const Contact> contacts) {
    for (const Contact& contact : contacts) {
        const auto a = number_of(play, BallId{contact.a});
        if (contact.kind == ContactKind::ball_ball) {
            const auto b = number_of(play, BallId{contact.b});
            if (!a || !b || play.shot.first_hit) continue;
            if (*a == cue_ball || *b == cue_ball) play.shot.first_hit = *a == cue_ball ? *b : *a;
            continue;
        }
        if (!a) continue;
        if (play.shot.first_hit) play.shot.rail_after_hit = true;
        play.shot.railed |= std::uint32_t{1} << *a;
    }
}

void note_pocketed(const Scene& scene, const World& world, PoolPlay& play) {
    auto removal = world.removed.end();
    while (removal != world.removed.begin() && std::prev(removal)->tick == world.tick)
        --removal;
    for (; removal != world.removed.end(); ++removal) {
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

std::optional<int> number_of(const PoolPlay& play, BallId ball) {
    const auto found = std::ranges::find(play.balls, std::optional(ball));
    if (found == play.balls.end()) return std::nullopt;
    return static_cast<int>(found - play.balls.begin());
}

Vec2 head_spot(const Scene& scene) {
    // The head spot lies as far from the middle of the table as the foot spot.
    Vec2 middle;
    for (const std::uint32_t pocket : scene.pool.pockets)
        middle += scene.world.zones[pocket].shape.start;
    middle = middle / static_cast<double>(scene.pool.pockets.size());
    return middle * 2.0 - rack_of(scene).foot;
}

std::optional<PoolPlay> begin_pool(const Scene& scene, int breaker) {
    if (scene.game != "eightball" && scene.game != "nineball") return std::nullopt;
    PoolPlay play;
    play.rules =
        begin_rack(scene.game == "eightball" ? PoolGame::eight_ball : PoolGame::nine_ball, breaker);
    const int count = static_cast<int>(rack_of(scene).balls.size());
    for (int ball = 0; ball <= count; ++ball)
        play.balls[static_cast<std::size_t>(ball)] = first_id(scene, ball);
    return play;
}

std::optional<std::string> refusal_to_shoot(const PoolPlay& play, BallId ball) {
    if (play.is_shooting) return "the balls still roll";
    if (play.rules.phase == PoolPhase::over) return "the rack is over";
    if (play.rules.phase == PoolPhase::choosing) return "there is something to decide first";
    if (play.balls[cue_ball] != std::optional(ball)) return "only the cue ball is struck";
    return std::nullopt;
}

std::optional<std::string> refusal_to_place(const Scene& scene, const PoolPlay& play, BallId ball,
                                            Vec2 place) {
    if (play.is_shooting) return "the balls still roll";
    if (play.balls[cue_ball] != std::optional(ball) || play.rules.in_hand == CueInHand::no)
        return "the ball stays where it lies";
    const Vec2 toward = rack_of(scene).toward;
    if (play.rules.in_hand == CueInHand::behind_head_string &&
        dot(place - head_spot(scene), toward) > 0.0)
        return "it must lie behind the head string";
    return std::nullopt;
}

void begin_shot(PoolPlay& play) {
    play.is_shooting = true;
    play.shot = {};
    ++play.shots;
}

void follow_pool(const Scene& scene, World& world, PoolPlay& play,
                 std::span<const Contact> contacts) {
    if (!play.is_shooting) return;
    note_contacts(play, contacts);
    note_pocketed(scene, world, play);
    if (!is_still(world)) return;
    play.is_shooting = false;
    carry_out(scene, world, play, judge(play.rules, play.call, play.shot));
}

void make_choice(const Scene& scene, World& world, PoolPlay& play, PoolChoice choice) {
    carry_out(scene, world, play, choose(play.rules, choice));
}

}  // namespace carom
