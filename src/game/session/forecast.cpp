#include "game/session/forecast.h"

#include <algorithm>
#include <utility>

namespace carom {
namespace {

void begin_tracks(Forecast& ahead) {
    const Balls& balls = ahead.world.balls();
    for (std::size_t i = 0; i < balls.size(); ++i)
        ahead.tracks.push_back({balls.id[i], {balls.position[i]}, std::nullopt});
}

// Tracks and balls are in the same order, and balls are only ever removed.
void extend_tracks(Forecast& ahead) {
    const Balls& balls = ahead.world.balls();
    std::size_t track = 0;
    for (std::size_t i = 0; i < balls.size() && track < ahead.tracks.size(); ++i) {
        while (track < ahead.tracks.size() && ahead.tracks[track].ball < balls.id[i])
            ++track;
        if (track == ahead.tracks.size() || ahead.tracks[track].ball != balls.id[i]) continue;
        std::vector<Vec2>& way = ahead.tracks[track].way;
        if (!(way.back() == balls.position[i])) way.push_back(balls.position[i]);
    }
}

void end_tracks(Forecast& ahead, std::size_t removals_before) {
    for (std::size_t i = removals_before; i < ahead.world.ledger().removed.size(); ++i) {
        const Removal& removal = ahead.world.ledger().removed[i];
        const auto track = std::ranges::find(ahead.tracks, removal.id, &Forecast::Track::ball);
        if (track == ahead.tracks.end() || removal.zone < 0) continue;
        track->zone = static_cast<std::uint32_t>(removal.zone);
        track->way.push_back(ahead.world.zones()[*track->zone].shape.start);
    }
    std::erase_if(ahead.tracks, [](const Forecast::Track& track) { return track.way.size() < 2; });
}

void note_first_hit(Forecast& ahead, const Solver& solver, BallId struck) {
    if (ahead.first_hit) return;
    for (const Contact& contact : solver.contacts()) {
        if (contact.kind != ContactKind::ball_ball) continue;
        if (contact.a != number(struck) && contact.b != number(struck)) continue;
        ahead.first_hit = BallId{contact.a == number(struck) ? contact.b : contact.a};
        return;
    }
}

// Whether the balls lie still and the rules have yet to judge the shot (RuleBook::settle).
bool is_settling(const GameState& game) {
    const auto* const shots = std::get_if<ShotsState>(&game);
    return shots && shots->is_shooting && shots->rested > 0;
}

}  // namespace

Forecast forecast(const Scene& scene, const World& world, const GameState& game, Solver& solver,
                  const command::Strike& strike, double seconds, Tracks tracks) {
    Forecast ahead;
    ahead.world = world;
    ahead.game = game;
    execute(scene, ahead.world, ahead.game, strike);
    if (tracks == Tracks::all) begin_tracks(ahead);
    const std::size_t removals = world.ledger().removed.size();
    const auto ticks = static_cast<std::uint64_t>(seconds * world.rate());
    for (std::uint64_t tick = 0; tick < ticks && (!ahead.comes_to_rest || is_settling(ahead.game));
         ++tick) {
        solver.tick(ahead.world);
        note_first_hit(ahead, solver, strike.ball);
        ahead.comes_to_rest = is_at_rest(ahead.world);
        if (tracks == Tracks::all) extend_tracks(ahead);
        update_game(scene, ahead.world, ahead.game, solver.contacts());
    }
    if (tracks == Tracks::all) end_tracks(ahead, removals);
    return ahead;
}

}  // namespace carom
