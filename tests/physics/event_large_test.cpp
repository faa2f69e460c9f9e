#include "physics/fingerprint.h"
#include "physics/solver.h"

#include <doctest/doctest.h>

#include "physics/support/scenes.h"

using namespace carom;

// From some thousand balls on the solver fetches from memory ahead of its events, by what it knows
// then of who and where that will be.
TEST_CASE("event: many balls go on with the same bits, and while they become few") {
    for (const bool torus : {false, true}) {
        CAPTURE(torus);
        World world = scenes::gas(5'000, 1, torus);
        World fresh = world;
        Solver solver({.kind = SolverKind::event});
        for (int tick = 0; tick < 8; ++tick) {
            if (tick == 3 || tick == 6)
                for (World* each : {&world, &fresh})
                    for (int i = 0; i < 300; ++i)
                        remove_ball(*each, each->balls.id[each->balls.size() - 1 - 7 * i]);
            REQUIRE(solver.tick(world) == TickOutcome::done);
            REQUIRE(Solver({.kind = SolverKind::event}).tick(fresh) == TickOutcome::done);
            REQUIRE(fingerprint(world) == fingerprint(fresh));
        }
        CHECK(world.balls.size() == 4'400);
        CHECK(world.ball_ball_collisions > 1'000);
    }
}
