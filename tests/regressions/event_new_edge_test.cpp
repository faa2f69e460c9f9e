#include <cmath>

#include <doctest/doctest.h>

#include "physics/solver.h"
#include "physics/support/scenes.h"

// An edge moved to a place that a ball had already passed on its current trajectory. The ball then
// bounced wherever it was by that time: in mid-air, or high above a flipper raised behind it.

using namespace carom;

TEST_CASE("event: an edge moved to a place that a ball has passed does not stop the ball") {
    // The ball flies up through 2 to 5 and falls again.
    for (const int when : {60, 110, 125, 135}) {
        CAPTURE(when);
        World world = scenes::empty();
        world.edit_definition().rate = 100.0;
        world.edit_definition().model.gravity = Vec2{0.0, -10.0};
        add_ball(world, {.velocity = {0.0, 10.0}, .radius = 0.5});
        Solver solver({.kind = SolverKind::event});
        int contacts = 0;
        for (int tick = 0; tick < 180; ++tick) {
            if (tick == when) add_capsule(world, {{-5.0, 2.0}, {5.0, 2.0}, 0.0}, 0);
            solver.tick(world);
            for (const Contact& contact : solver.contacts()) {
                ++contacts;
                CHECK(contact.point.y == doctest::Approx(2.0));
                // By now the ball has fallen from 5 to 2.5.
                CHECK(contact.time == doctest::Approx(1.0 + std::sqrt(0.5)));
            }
        }
        CHECK(contacts == 1);
    }
}
