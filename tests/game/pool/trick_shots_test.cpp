#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>

#include "game/session/forecast.h"
#include "game/support/shipped.h"

using namespace carom;
using carom::test::named;

namespace {

// The shot that the level's comment describes.
struct Trick {
    std::string level;
    std::string at;  ///< the ball that is aimed at, full; empty: straight to the right
    double speed;    ///< m/s
    double follow;
    std::vector<std::string> falls;
};

const Trick tricks[] = {
    {"trick-fork", "", 3.0, 0.0, {"left", "right"}},
    {"trick-dead-line", "third", 3.0, 0.0, {"first"}},
    {"trick-there-and-back", "far", 4.0, -0.5, {"far", "near"}},
    {"drill-draw", "object", 2.5, -0.4, {"object"}},
};

}  // namespace

TEST_CASE("the trick shots do what their levels describe") {
    for (const Trick& trick : tricks) {
        CAPTURE(trick.level);
        const Scene scene = test::shipped_level(trick.level);
        const World& world = scene.world;
        const BallId cue = scene.pool.cue->ball;
        const Vec2 from = world.balls().position[*index_of(world, cue)];
        Vec2 way{1.0, 0.0};
        if (!trick.at.empty()) {
            const Vec2 apart =
                world.balls().position[*index_of(world, named(scene, trick.at))] - from;
            way = apart / length(apart);
        }
        Solver solver(pick_solver(world).settings);
        const Forecast ahead =
            forecast(scene, world, {}, solver,
                     {.ball = cue, .velocity = way * trick.speed, .follow = trick.follow}, 60.0,
                     Tracks::none);
        CHECK(ahead.comes_to_rest);
        std::vector<std::string> fell;
        for (const Removal& removal : ahead.world.ledger().removed)
            fell.push_back(scene.ball_names[number(removal.id)]);
        std::ranges::sort(fell);
        CHECK(fell == trick.falls);
    }
}
