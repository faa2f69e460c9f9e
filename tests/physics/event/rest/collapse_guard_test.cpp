#include "physics/event/rest/collapse_guard.h"

#include <doctest/doctest.h>

#include "physics/event/motion/event_memory.h"
#include "physics/event/motion/tolerances.h"
#include "physics/solver.h"
#include "physics/support/event_parts.h"
#include "physics/support/scenes.h"
#include "physics/world/solver_access.h"

using namespace carom;

namespace {

World one_ball(bool has_gravity, Vec2 velocity = {}) {
    World world = scenes::empty();
    world.edit_definition().model.inelastic = true;
    if (has_gravity) world.edit_definition().model.gravity = Vec2{0.0, -8.0};
    add_ball(world, {.velocity = velocity, .radius = 1.0});
    return world;
}

}  // namespace

TEST_CASE("collapse guard: quick succession counts, and a pause resets at the same pace") {
    EventParts parts(one_ball(true));
    Trajectory<double> before = parts.balls.trajectory(0);
    before.recent_collisions = 10;
    // A fall through the radius takes 0.5 s.
    const double quick = 0.5 * quick_succession;
    const double start = before.time;
    parts.scene.now = start + 0.9 * quick;
    CHECK(parts.guard.count(0, before, {}) == 11);
    parts.scene.now = start + 3.5 * quick;
    CHECK(parts.guard.count(0, before, {}) == 7);
    parts.scene.now = start + 100.0 * quick;
    CHECK(parts.guard.count(0, before, {}) == 0);
}

TEST_CASE("collapse guard: without gravity, collisions in place count") {
    EventParts parts(one_ball(false));
    Trajectory<double> before = parts.balls.trajectory(0);
    before.recent_collisions = 10;
    CHECK(parts.guard.count(0, before, {0.5 * contact_slop, 0.0}) == 11);
    CHECK(parts.guard.count(0, before, {2.0 * contact_slop, 0.0}) == 0);
}

TEST_CASE("collapse guard: the count remains if no impact ends a trajectory, and pauses reset it") {
    for (const bool has_gravity : {true, false}) {
        CAPTURE(has_gravity);
        EventParts parts(one_ball(has_gravity, {1.0, 0.0}));
        parts.balls[0].line.recent_collisions = 10;
        CHECK(parts.guard.remaining(0) == 10);
        parts.scene.now += 3.5 * 0.5 * quick_succession;
        CHECK(parts.guard.remaining(0) == (has_gravity ? 7 : 0));
        parts.scene.now += 1.0;
        CHECK(parts.guard.remaining(0) == 0);
    }
}

// Regression: balls that the stop speed stops began to count anew in every tick. Under weak gravity
// such balls sank into one another without end (check-scenes 4005571). The speed limit changes
// velocities in the same place.
TEST_CASE("collapse guard: collisions add up, although every tick changes the velocity") {
    World world = one_ball(true, {0.0, -1.0});
    world.edit_definition().model.gravity = Vec2{0.0, -1e-3};
    world.edit_definition().model.speed_limit = 1.0;
    const auto recent = [](const World& any) {
        return event_memory(any).trajectories.lines[0].recent_collisions;
    };
    Solver solver({.kind = SolverKind::event});
    solver.tick(world);
    SolverAccess(world).memory().use<EventMemory>().trajectories.lines[0].recent_collisions = 10;
    SolverAccess(world).stamp_memory();
    for (int tick = 0; tick < 3; ++tick) {
        World copy = world;
        Solver(SolverSettings{.kind = SolverKind::event}).tick(copy);
        CHECK(recent(copy) == 10);
        solver.tick(world);
        CHECK(recent(world) == 10);
        CHECK(world.balls().velocity[0] == Vec2{0.0, -1.0});
    }
}

TEST_CASE("collapse guard: slow balls are frozen above the limit, fast ones never") {
    const auto is_frozen_after = [](Vec2 velocity, std::uint32_t collisions, bool is_jammed) {
        EventParts parts(one_ball(true, velocity));
        parts.balls[0].line.recent_collisions = collisions;
        parts.guard.freeze_if_due(0, is_jammed);
        const bool is_frozen = parts.guard.is_frozen(parts.balls.trajectory(0));
        if (is_frozen) CHECK(parts.balls[0].line.recent_collisions == collisions_after_freezing);
        if (is_frozen) CHECK(parts.guard.thaw_time(0) == doctest::Approx(parts.scene.now + 0.125));
        return is_frozen;
    };
    CHECK(!is_frozen_after({}, most_collisions_before_freezing, false));
    CHECK(is_frozen_after({}, most_collisions_before_freezing + 1, false));
    CHECK(!is_frozen_after({}, most_recent_collisions, true));
    CHECK(is_frozen_after({}, most_recent_collisions + 1, true));
    // A fall through the diameter ends at 4 sqrt(2).
    CHECK(is_frozen_after({3.9, 0.0}, most_collisions_before_freezing + 1, false));
    CHECK(!is_frozen_after({4.1, 0.0}, most_collisions_before_freezing + 1, false));
}

TEST_CASE("collapse guard: dense balls are listed once, while they are dense") {
    EventParts parts(one_ball(true));
    parts.guard.begin_tick();
    parts.balls[0].line.recent_collisions = dense_collisions + 1;
    parts.guard.note_dense(0);
    parts.guard.note_dense(0);
    CHECK(parts.guard.dense() == std::vector<std::uint32_t>{0});
    parts.balls[0].line.recent_collisions = dense_collisions;
    CHECK(parts.guard.dense().empty());
}
