#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "physics/event/motion/event_memory.h"
#include "physics/memory/prefetch.h"
#include "physics/solver.h"
#include "physics/world/fingerprint.h"

#include "physics/support/scenes.h"

using namespace carom;

// With some thousand balls or more the solver prefetches for coming events, by what it knows of
// their balls and places.
TEST_CASE("event: many balls continue with the same bits, even as they become few") {
    for (const bool torus : {false, true}) {
        CAPTURE(torus);
        World world = scenes::gas(5'000, 1, torus);
        World fresh = world;
        Solver solver({.kind = SolverKind::event});
        for (int tick = 0; tick < 8; ++tick) {
            if (tick == 3 || tick == 6)
                for (World* each : {&world, &fresh})
                    for (int i = 0; i < 300; ++i)
                        remove_ball(*each, each->balls().id[each->balls().size() - 1 - 7 * i]);
            REQUIRE(solver.tick(world) == TickOutcome::done);
            REQUIRE(Solver({.kind = SolverKind::event}).tick(fresh) == TickOutcome::done);
            REQUIRE(fingerprint(world) == fingerprint(fresh));
        }
        CHECK(world.balls().size() == 4'400);
        CHECK(world.ledger().ball_ball_collisions > 1'000);
    }
}

// For so many balls it keeps digests to detect outside changes.
TEST_CASE("event: a change to one of very many balls is noticed") {
    struct Row {
        std::string what;
        std::function<void(World&)> change;
    };
    const std::vector<Row> rows{
        {"nothing", [](World&) {}},
        {"one turns", [](World& w) { w.edit_balls().velocity[17].y = -w.balls().velocity[17].y; }},
        {"two exchange velocities",
         [](World& w) { std::swap(w.edit_balls().velocity[100], w.edit_balls().velocity[8'000]); }},
        {"two exchange places",
         [](World& w) { std::swap(w.edit_balls().position[100], w.edit_balls().position[101]); }},
        {"one moves by a hair",
         [](World& w) {
             w.edit_balls().position[8'500].x = std::nextafter(w.balls().position[8'500].x, 0);
         }},
        {"all turn back",
         [](World& w) {
             for (Vec2& velocity : w.edit_balls().velocity)
                 velocity = -velocity;
         }},
    };
    World world = scenes::gas(9'000, 1, false);
    REQUIRE(world.balls().size() >= too_many_to_cache);
    Solver solver({.kind = SolverKind::event});
    for (const Row& row : rows) {
        CAPTURE(row.what);
        REQUIRE(solver.tick(world) == TickOutcome::done);
        row.change(world);
        World fresh = world;
        REQUIRE(solver.tick(world) == TickOutcome::done);
        REQUIRE(Solver({.kind = SolverKind::event}).tick(fresh) == TickOutcome::done);
        CHECK(fingerprint(world) == fingerprint(fresh));
        CHECK(world.balls().position == fresh.balls().position);
        CHECK(event_memory(world).trajectories.lines == event_memory(fresh).trajectories.lines);
    }
}
