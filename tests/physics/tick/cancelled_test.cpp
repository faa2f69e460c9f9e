#include <doctest/doctest.h>

#include "physics/solver.h"
#include "physics/support/cancelled.h"
#include "physics/support/scenes.h"
#include "physics/world/fingerprint.h"

using namespace carom;

namespace {

// Everything that a tick may change: balls are emitted, an edge is dragged, a flipper turns,
// contacts scatter.
World busy(bool torus) {
    World world = scenes::gas(1000, 6, torus);
    world.edit_definition().rate = 0.5;
    world.edit_definition().model.scatter = 0.1;
    world.edit_balls().edge_contacts.assign(world.balls().size(), 0);
    world.edit_definition().kinds.push_back({.radius = 0.3, .mass = 0.1, .restitution = 0.5});
    world.edit_emitters().push_back(
        {.kind = 1, .at = {-40, -40}, .velocity = {3, 1}, .every = 0.01, .count = 50});
    const CapsuleId dragged = add_capsule(world, {{10, 10}, {20, 12}, 0.2}, 0);
    world.edit_held_capsules().push_back({dragged, {14, 12}, {25, 15}});
    const CapsuleId turned = add_capsule(world, {{40, 30}, {46, 30}, 0.3}, 0);
    world.edit_flippers().push_back(
        {.capsule = turned, .length = 6.0, .rest = {1, 0}, .sweep = 1.0, .is_pressed = true});
    return world;
}

SolverSettings settings_for(SolverKind kind) {
    return {.kind = kind, .updates = 20, .steps = 20, .substeps = 3};
}

}  // namespace

TEST_CASE("a cancelled tick leaves the world unchanged, wherever it stops") {
    for (const SolverKind kind : {SolverKind::substep, SolverKind::swept, SolverKind::event}) {
        CAPTURE(name(kind));
        for (const bool torus : {false, true}) {
            const World start = busy(torus);
            World world = start;
            Solver solver(settings_for(kind));
            cancel_at_each_poll(world, solver, [&] {
                REQUIRE(world.next_ball() == start.next_ball());
                REQUIRE(world.model() == start.model());
                REQUIRE(world.balls().restitution.empty());
                REQUIRE(world.balls().radius == start.balls().radius);
                REQUIRE(world.held_capsules().size() == 1);
                REQUIRE(solver.contacts().empty());
            });
            if (!torus) CHECK(world.balls().size() > start.balls().size());
        }
    }
}

// `contact` can be cancelled only where nothing can press, since it then uses `swept`.
TEST_CASE("a tick of contact in a gas can be cancelled too, and leaves the world unchanged") {
    World world = scenes::gas(5000, 6);
    Solver solver({.kind = SolverKind::contact});
    solver.tick(world);
    const World start = world;
    CHECK(solver.tick(world, [] { return false; }) == TickOutcome::cancelled);
    CHECK(fingerprint(world) == fingerprint(start));
    CHECK(solver.contacts().empty());
}

TEST_CASE("solvers with bounded ticks do not ask") {
    for (const SolverKind kind : {SolverKind::discrete, SolverKind::contact}) {
        CAPTURE(name(kind));
        World world = scenes::gas(5000, 6);
        world.edit_definition().model.gravity = Vec2{0.0, -1.0};
        const auto never = [] { return false; };
        CHECK(Solver({.kind = kind}).tick(world, never) == TickOutcome::done);
    }
}
