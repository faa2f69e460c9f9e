#include <doctest/doctest.h>

#include "physics/event/hybrid_cluster.h"
#include "physics/event/motion/event_memory.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"
#include "physics/world/fingerprint.h"

// In a hybrid step of the solver `event`, the part outside of the cluster went on with an edge
// where a hand had held it a tick ago: the hand had moved the edge in the cluster, and then let go.
// Before that, the part went on without testing the edge against the past of its trajectories,
// which a run from a snapshot did: other bits from the same state.

using namespace carom;

namespace {

// A pile of three balls between walls on the left of a long edge, which stays a cluster, and a free
// ball above the edge's right end. A hand moves the edge along itself, so that it ends to the left
// of that ball.
struct SlidingEdge {
    World world = scenes::empty();
    CapsuleId edge{};

    SlidingEdge() {
        world.edit_definition().rate = 100.0;
        world.edit_definition().model.gravity = Vec2{0.0, -10.0};
        world.edit_definition().model.inelastic = true;
        world.edit_definition().kinds[0] = {.radius = 0.5, .mass = 1.0, .restitution = 0.5};
        world.edit_definition().materials[0].restitution = 0.5;
        edge = add_capsule(world, {{-10.0, 0.0}, {10.0, 0.0}, 0.0}, 0);
        add_capsule(world, {{-8.5, 0.3}, {-8.5, 3.0}, 0.0}, 0);
        add_capsule(world, {{-6.5, 0.3}, {-6.5, 3.0}, 0.0}, 0);
        add_ball(world, {.position = {-8.0, 0.5}, .velocity = {}});
        add_ball(world, {.position = {-7.0, 0.5}, .velocity = {}});
        add_ball(world, {.position = {-7.5, 1.366}, .velocity = {}});
        add_ball(world, {.position = {9.97, 3.0}, .velocity = {}});
        // Of few balls a hand makes no clusters.
        for (int i = 0; i < static_cast<int>(HybridCluster::most_pushed); ++i)
            add_ball(world, {.position = {100.0 + 3.0 * i, 50.0}, .velocity = {}});
        edit_event_memory(world).clustered = {BallId{0}, BallId{1}, BallId{2}};
    }

    void slide() {
        const Capsule& shape = world.capsules().shape[0];
        const Vec2 left{-0.05, 0.0};
        world.edit_held_capsules() = {{edge, shape.start + left, shape.end + left}};
    }
};

}  // namespace

TEST_CASE("event: a hand that moved an edge in a cluster lets go of it for all balls") {
    SlidingEdge scene;
    World& whole = scene.world;
    World parted = whole;
    Solver solver({.kind = SolverKind::event});
    bool was_parted = false;
    for (int tick = 0; tick < 100; ++tick) {
        CAPTURE(tick);
        if (tick == 3)
            scene.slide();
        else
            whole.edit_held_capsules().clear();
        parted.edit_held_capsules() = whole.held_capsules();
        solver.tick(whole);
        Solver({.kind = SolverKind::event}).tick(parted);
        REQUIRE(fingerprint(whole) == fingerprint(parted));
        was_parted = was_parted || (tick > 3 && event_memory(whole).clustered.size() == 3);
    }
    CHECK(was_parted);
    CHECK(whole.capsules().shape[0].end.x == 9.95);
    // It has bounced off the end of the edge, and not off its side.
    CHECK(whole.balls().velocity[3].x > 0.0);
}

// Lifted edges are stepped by `contact`, with the balls that lie on them. Without a ball there was
// nothing to choose the substeps by, and the program crashed.
TEST_CASE("event: a hand lifts an edge on which nothing lies") {
    SlidingEdge scene;
    World& world = scene.world;
    edit_event_memory(world).clustered.clear();
    const CapsuleId shelf = add_capsule(world, {{-60.0, 0.0}, {-50.0, 0.0}, 0.0}, 0);
    Solver solver({.kind = SolverKind::event});
    for (int tick = 1; tick <= 10; ++tick) {
        const double height = 0.05 * tick;
        world.edit_held_capsules() = {{shelf, {-60.0, height}, {-50.0, height}}};
        solver.tick(world);
    }
    CHECK(world.capsules().shape.back().start.y == doctest::Approx(0.5));
}
