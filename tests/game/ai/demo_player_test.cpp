#include "game/ai/demo_player.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "game/ai/pinball_sight.h"
#include "game/pinball/pinball.h"
#include "game/session/game_state.h"
#include "game/support/shipped.h"
#include "physics/solver.h"
#include "support/sanitizers.h"

using namespace carom;

namespace {

/// Whether a ball that starts there, beside the flippers, is lost before it comes between them or
/// goes up; without kickbacks.
bool is_lost_from(const Scene& scene, Vec2 at, Vec2 velocity, bool has_player) {
    World world = scene.world;
    GameState game = begin_game(scene);
    auto& state = std::get<PinballState>(game);
    state.is_launched = true;
    for (std::uint32_t d = 0; d < scene.table.devices.size(); ++d)
        if (scene.table.devices[d].kind == DeviceKind::kickback) state.is_lit[d] = 0;
    world.edit_balls().position[0] = at;
    world.edit_balls().velocity[0] = velocity;
    Solver solver(pick_solver(world).settings);
    const PinballSight sight(scene);
    DemoPlayer player;
    const BallId ball = world.balls().id[0];
    const auto end = static_cast<std::uint64_t>(3.0 * world.rate());
    while (world.tick() < end) {
        const auto index = index_of(world, ball);
        if (!index || sight.is_lost(world, *index)) return true;
        const Vec2 place = world.balls().position[*index];
        if (std::abs(place.x - 0.236) < 0.08 || place.y > 0.45) return false;
        if (has_player)
            for (const command::Press& press : player.play(scene, world, state))
                execute(scene, world, game, press);
        solver.tick(world);
        update_game(scene, world, game, solver.contacts());
    }
    return false;
}

}  // namespace

// A slow ball above the post between inlane and outlane takes a second to roll down the outlane, so
// there is time for a nudge while it is still above the post.
TEST_CASE("the demonstration player nudges slow balls away from the outlanes") {
    for (const std::string& name : test::pinball_tables()) {
        if (test::has_sanitizers && name != "three-bumpers") continue;  // slow
        CAPTURE(name);
        const Scene scene = test::shipped_level(name);
        int taken = 0;
        int saved = 0;
        for (int i = 0; i < 4; ++i) {
            const bool is_left = i % 2 == 0;
            const double from_wall = 0.023 + 0.006 * (i / 2);
            const Vec2 at{is_left ? from_wall : 0.472 - from_wall, 0.325};
            const Vec2 velocity{is_left ? -0.03 : 0.03, 0.0};
            if (!is_lost_from(scene, at, velocity, false)) continue;
            ++taken;
            saved += is_lost_from(scene, at, velocity, true) ? 0 : 1;
        }
        CAPTURE(taken);
        CAPTURE(saved);
        CHECK(taken >= 2);
        CHECK(2 * saved >= taken);
    }
}
