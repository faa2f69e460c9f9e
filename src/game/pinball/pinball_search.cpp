#include "game/pinball/pinball_search.h"

#include <algorithm>

#include "game/pinball/pinball.h"
#include "geometry/closest.h"
#include "geometry/elementary.h"
#include "physics/world/random.h"

namespace carom {
namespace {

constexpr double stuck_time = 5.0;  // s in which a ball has moved less than a radius
constexpr std::uint32_t most_kicks = 4;
constexpr double kick = 60.0;          // radii a second
constexpr double off_the_table = 8.0;  // radii beyond the camera's view

bool is_off(const Pinball& game, std::size_t ball) {
    const Box table = grow(game.scene.view, off_the_table * game.radius());
    const Vec2 at = game.world.balls().position[ball];
    return at.x < table.low.x || at.x > table.high.x || at.y < table.low.y || at.y > table.high.y;
}

bool is_cradled(const Pinball& game, std::size_t ball) {
    const World& world = game.world;
    return std::ranges::any_of(world.flippers(), [&](const Flipper& flipper) {
        const auto index = index_of(world, flipper.capsule);
        if (!index || !flipper.is_pressed) return false;
        const Disc disc{world.balls().position[ball], world.balls().radius[ball]};
        return separation(disc, world.capsules().shape[*index]) < 0.3 * disc.radius;
    });
}

// The direction away from the nearest edge, turned randomly to one side or the other.
Vec2 direction_away(const Pinball& game, std::size_t ball) {
    const World& world = game.world;
    const Vec2 at = world.balls().position[ball];
    std::optional<double> nearest;
    Vec2 away{0.0, 1.0};
    for (std::size_t i = 0; i < world.capsules().size(); ++i) {
        if (world.model().one_way && world.capsules().side[i] == Side::none) continue;
        const Capsule& shape = world.capsules().shape[i];
        const Vec2 offset = at - closest_point(shape.start, shape.end, at);
        const double gap = length(offset) - shape.radius;
        if ((nearest && gap >= *nearest) || !(length(offset) > 0.0)) continue;
        nearest = gap;
        away = offset / length(offset);
    }
    const double angle = random_between(-0.8, 0.8, world.seed(), RandomStream::player,
                                        number(world.balls().id[ball]), game.state.searches);
    const auto [sine, cosine] = sin_cos(angle);
    return away * cosine + perpendicular(away) * sine;
}

void remove_and_serve(Pinball game, BallId ball) {
    remove_ball(game.world, ball);
    ++game.state.removals_seen;  // so that the removal does not count as a drain
    ++game.state.lost;
    ++game.state.to_serve;
    game.state.serves_itself = true;
}

}  // namespace

void search_balls(Pinball game) {
    World& world = game.world;
    std::vector<PinballState::Progress> progress;
    std::vector<BallId> given_up;
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        const BallId id = world.balls().id[i];
        const Vec2 at = world.balls().position[i];
        const auto known =
            std::ranges::lower_bound(game.state.progress, id, {}, &PinballState::Progress::ball);
        PinballState::Progress ball{id, at, game.now(), 0};
        if (known != game.state.progress.end() && known->ball == id) ball = *known;
        const bool gets_on = distance(at, ball.place) > world.balls().radius[i];
        if (gets_on) ball = {id, at, game.now(), 0};
        if (!is_in_play(game.scene, game.state, id)) continue;
        if (is_off(game, i)) {
            given_up.push_back(id);
            continue;
        }
        const bool is_due = game.now() >= ball.since + game.ticks(stuck_time);
        if (is_due) {
            const bool may_stay =
                is_cradled(game, i) || is_held(game.state, id) || is_on_plunger(game.scene, world);
            ball.since = game.now();
            if (!may_stay && ball.searches >= most_kicks) {
                given_up.push_back(id);
                continue;
            }
            if (!may_stay) {
                ++ball.searches;
                ++game.state.searches;
                world.edit_balls().velocity[i] +=
                    direction_away(game, i) * (kick * world.balls().radius[i]);
            }
        }
        progress.push_back(ball);
    }
    game.state.progress = std::move(progress);
    for (const BallId id : given_up)
        remove_and_serve(game, id);
}

}  // namespace carom
