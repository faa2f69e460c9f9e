#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "game/pinball/pinball.h"
#include "game/session/game_state.h"
#include "game/support/shipped.h"
#include "physics/solver.h"
#include "support/sanitizers.h"

// Launches and outlanes of the shipped tables.
using namespace carom;

namespace {

const std::vector<std::string> tables = test::pinball_tables();

/// A shipped table with its first ball on the plunger.
struct Table {
    explicit Table(const Scene& of)
        : scene(of),
          world(of.world),
          game(begin_game(of)),
          solver(pick_solver(of.world).settings) {}

    void run(double seconds) {
        for (int i = 0; i < static_cast<int>(seconds * world.rate()); ++i)
            tick();
    }
    void tick() {
        solver.tick(world);
        update_game(scene, world, game, solver.contacts());
    }
    PinballState& state() { return std::get<PinballState>(game); }
    std::int64_t& variable(const std::string& name) {
        const auto found = std::ranges::find(scene.rules.variables, name, &RuleVariable::name);
        REQUIRE(found != scene.rules.variables.end());
        std::size_t slot = 0;
        for (auto v = scene.rules.variables.begin(); v != found; ++v)
            slot += v->scope == RuleScope::player ? scene.rules.players : 1;
        return state().rules.values[slot];
    }

    const Scene& scene;
    World world;
    GameState game;
    Solver solver;
};

// The pivots of the lower flippers.
std::pair<Vec2, Vec2> lower_pivots(const Scene& scene) {
    std::vector<Vec2> pivots;
    for (const Flipper& flipper : scene.world.flippers())
        pivots.push_back(
            scene.world.capsules().shape[*index_of(scene.world, flipper.capsule)].start);
    std::ranges::sort(pivots, {}, &Vec2::y);
    return pivots[0].x < pivots[1].x ? std::pair(pivots[0], pivots[1])
                                     : std::pair(pivots[1], pivots[0]);
}

/// Whether the ball leaves through an outlane; nudged once after `nudge_after`, if that is not
/// negative.
bool drains_outside(const Scene& scene, Vec2 at, Vec2 velocity, double nudge_after, Button nudge) {
    Table table(scene);
    for (std::uint32_t d = 0; d < scene.table.devices.size(); ++d)
        if (scene.table.devices[d].kind == DeviceKind::kickback) table.state().is_lit[d] = 0;
    const auto [left, right] = lower_pivots(scene);
    table.world.edit_balls().position[0] = at;
    table.world.edit_balls().velocity[0] = velocity;
    const auto due = static_cast<std::uint64_t>(nudge_after * table.world.rate());
    for (std::uint64_t tick = 0; tick < 3000 && table.world.balls().size() > 0; ++tick) {
        if (nudge_after >= 0.0 && tick == due)
            press(scene, table.world, table.state(), nudge, true);
        const Vec2 place = table.world.balls().position[0];
        if (place.y < left.y) return place.x < left.x || place.x > right.x;
        table.tick();
    }
    return false;
}

}  // namespace

TEST_CASE("each skill shot is made by some pulls of the plunger, and by no means by all") {
    for (const std::string& name : tables) {
        CAPTURE(name);
        const Scene scene = test::shipped_level(name);
        for (int skill = 1; skill <= 3; ++skill) {
            if (test::has_sanitizers && skill != 1) continue;  // slow
            CAPTURE(skill);
            int made = 0;
            constexpr int pulls = 12;
            for (int i = 0; i < pulls; ++i) {
                CAPTURE(i);
                Table table(scene);
                table.run(0.6);
                table.variable("skill") = skill;
                pull_plunger(scene, table.world, table.state(), 0.46 + 0.049 * i, true);
                table.run(5.5);
                CHECK(table.variable("skill") == 0);
                made += static_cast<int>(table.variable("aims"));
            }
            CHECK(made >= 1);
            CHECK(made <= pulls * 3 / 5);
        }
    }
}

// Balls that come down at a wall above an outlane. Which ones a nudge saves, it saves in time.
TEST_CASE("a nudge saves some of the balls that an outlane would take, and not all") {
    for (const std::string& name : tables) {
        CAPTURE(name);
        const Scene scene = test::shipped_level(name);
        const auto [left, right] = lower_pivots(scene);
        const double middle = 0.5 * (left.x + right.x);
        int taken = 0;
        int saved = 0;
        for (int i = 0; i < 24; ++i) {
            const double side = i % 2 == 0 ? -1.0 : 1.0;
            const Vec2 at{middle + side * (0.170 + 0.004 * (i / 2 % 6)), 0.36};
            const Vec2 velocity{side * (0.1 + 0.15 * (i / 12)), -0.4};
            if (!drains_outside(scene, at, velocity, -1.0, Button::nudge_up)) continue;
            ++taken;
            bool is_saved = false;
            for (int moment = 0; moment < 8 && !is_saved; ++moment)
                for (const Button nudge :
                     {Button::nudge_left, Button::nudge_right, Button::nudge_up})
                    is_saved =
                        is_saved || !drains_outside(scene, at, velocity, 0.04 * moment, nudge);
            saved += is_saved ? 1 : 0;
        }
        CAPTURE(taken);
        CAPTURE(saved);
        CHECK(taken >= 3);
        CHECK(saved >= 1);
        CHECK(5 * saved >= taken);
    }
}
