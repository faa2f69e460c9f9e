#include <vector>

#include <doctest/doctest.h>

#include "physics/solver.h"
#include "physics/support/scenes.h"

// A ball goes round a torus hundreds of times before it meets another. The periodic images between
// two trajectories are counted in eight bits, so a trajectory must restart in time.

using namespace carom;

TEST_CASE("event: a ball that has circled a torus hundreds of times still meets the other ball") {
    for (const double speed : {100.0, 1'000.0, 20'000.0}) {
        CAPTURE(speed);
        World world = scenes::empty();
        world.edit_definition().model.wrap = Box{{0.0, 0.0}, {10.0, 10.0}};
        add_ball(world, {.position = {5.0, 5.0}, .velocity = {speed, 0.0}, .radius = 0.5});
        add_ball(world, {.position = {2.0, 9.0}, .velocity = {0.0, -1.0}, .radius = 0.5});
        Solver solver({.kind = SolverKind::event});
        const double energy = speed * speed + 1.0;
        std::vector<Contact> contacts;
        for (int i = 0; i < 120 * 5; ++i) {
            solver.tick(world);
            contacts.insert(contacts.end(), solver.contacts().begin(), solver.contacts().end());
        }
        // They meet at the rim of the slow ball, which nothing has disturbed until then.
        REQUIRE(!contacts.empty());
        const Vec2 slow{2.0, 9.0 - contacts[0].time};
        CHECK(length(contacts[0].point - slow) == doctest::Approx(0.5).epsilon(1e-6));
        // The rows of the two overlap from the third second to the fifth.
        CHECK(world.ledger().ball_ball_collisions > 0);
        CHECK(length_squared(world.balls().velocity[0]) +
                  length_squared(world.balls().velocity[1]) ==
              doctest::Approx(energy).epsilon(1e-12));
    }
}
