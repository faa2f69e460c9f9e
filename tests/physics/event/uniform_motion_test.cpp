#include "physics/event/motion/event_memory.h"
#include "physics/solver.h"
#include "physics/world/fingerprint.h"

#include <doctest/doctest.h>

#include "physics/support/scenes.h"

using namespace carom;

namespace {

// Balls in contact and apart, of several sizes and masses, most of them close together.
World mixture(std::uint64_t seed, bool is_inelastic) {
    World world = scenes::gas(400, seed, false);
    world.edit_definition().rate = 20.0;
    world.edit_definition().model.inelastic = is_inelastic;
    if (is_inelastic) world.edit_balls().restitution.assign(world.balls().size(), 1.0);
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        world.edit_balls().radius[i] = 1.0 - 0.25 * static_cast<double>(i % 3);
        world.edit_balls().inverse_mass[i] = static_cast<double>(1 + i % 5);
        if (is_inelastic)
            world.edit_balls().restitution[i] = 0.5 + 0.1 * static_cast<double>(i % 6);
    }
    // Some touch in a row, so that one impact causes others at the same instant.
    for (std::size_t i = 0; i < 6; ++i)
        add_ball(world, {.position = {-20.0 - 2.0 * static_cast<double>(i), 5.0},
                         .velocity = {i == 0 ? -8.0 : 0.0, 0.0}});
    // Two that collide head-on, so that signs of zero matter.
    add_ball(world, {.position = {-40.0, 20.0}, .velocity = {3.0, -0.0}});
    add_ball(world, {.position = {-36.0, 20.0}, .velocity = {-3.0, -0.0}});
    return world;
}

}  // namespace

// If all balls move uniformly the solver takes a faster path. A collision matrix in which all
// collide changes nothing else.
TEST_CASE("event: gases have the same bits on the fast path and on the general one") {
    for (const bool is_inelastic : {false, true})
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            CAPTURE(is_inelastic);
            CAPTURE(seed);
            World by_lines = mixture(seed, is_inelastic);
            World by_all = by_lines;
            by_all.edit_definition().model.filtered = true;
            const std::size_t classes = by_all.kinds().size() + by_all.materials().size();
            by_all.edit_definition().meets.assign(classes * classes, 1);
            // A limit that no ball reaches has the solver store trajectories as they start.
            if (seed == 2)
                for (World* world : {&by_lines, &by_all})
                    world->edit_definition().model.speed_limit = 1e6;
            Solver short_way({.kind = SolverKind::event});
            Solver long_way({.kind = SolverKind::event});
            for (int tick = 0; tick < 30; ++tick) {
                REQUIRE(short_way.tick(by_lines) == TickOutcome::done);
                REQUIRE(long_way.tick(by_all) == TickOutcome::done);
                REQUIRE(fingerprint(by_lines) == fingerprint(by_all));
                REQUIRE(event_memory(by_lines).trajectories.lines ==
                        event_memory(by_all).trajectories.lines);
                REQUIRE(short_way.contacts().size() == long_way.contacts().size());
                for (std::size_t i = 0; i < short_way.contacts().size(); ++i) {
                    const Contact& a = short_way.contacts()[i];
                    const Contact& b = long_way.contacts()[i];
                    REQUIRE((a.time == b.time && a.kind == b.kind && a.a == b.a && a.b == b.b));
                    REQUIRE((a.point == b.point && a.normal == b.normal));
                    REQUIRE((a.approach == b.approach && a.impulse == b.impulse));
                }
            }
            CHECK(by_lines.ledger().ball_ball_collisions > 500);
            CHECK(by_lines.ledger().ball_edge_collisions > 50);
        }
}
