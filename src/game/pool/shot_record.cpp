#include "game/pool/shot_record.h"

#include <algorithm>
#include <iterator>

#include "game/pool/table_places.h"
#include "game/referees/referee.h"
#include "geometry/closest.h"

namespace carom {
namespace {

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

// Forgets the frozen balls that have left their edges, at the end of a tick.
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
    auto removal = world.ledger().removed.end();
    while (removal != world.ledger().removed.begin() && std::prev(removal)->tick == world.tick())
        --removal;
    for (; removal != world.ledger().removed.end(); ++removal) {
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

void begin_shot(const World& world, PoolPlay& play) {
    play.is_shooting = true;
    play.has_crossed = false;
    play.frozen = find_frozen(world, play);
    play.shooter = play.rules.player;
    play.shot = {};
    play.decision.reset();
    ++play.shots;
    play.lay.clear();
    if (!play.rules.referee->may_put_back()) return;
    for (std::size_t n = 0; n < play.balls.size(); ++n)
        if (play.balls[n])
            play.lay.push_back(
                {static_cast<int>(n), world.balls().position[*index_of(world, *play.balls[n])]});
}

void record_tick(const Scene& scene, const World& world, PoolPlay& play,
                 std::span<const Contact> contacts) {
    note_contacts(scene, world, play, contacts);
    note_pocketed(scene, world, play);
    thaw(world, play);
    if (play.has_crossed) return;
    const auto cue = play.balls[cue_ball] ? index_of(world, *play.balls[cue_ball]) : std::nullopt;
    if (cue && is_beyond_string(scene, world.balls().position[*cue])) play.has_crossed = true;
}

}  // namespace carom
