#include <cmath>
#include <cstdint>

#include <doctest/doctest.h>

#include "physics/event/motion/event_memory.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"

// Under the solver `event` a ball that rested on two supports lost them when friction had stopped
// its spin: from then on it counted as frozen. It started a trajectory every quarter of a fall
// through its radius, and when an edge that had supported it was taken away, it hung in the air
// until the next of these.

using namespace carom;

namespace {

// A ball of radius 1 that spins in a groove of two edges at right angles.
struct Groove {
    World world = scenes::empty();
    CapsuleId left{};

    explicit Groove(double spin) {
        world.edit_definition().rate = 120.0;
        world.edit_definition().model.gravity = Vec2{0.0, -10.0};
        world.edit_definition().model.spin = 0.5;
        world.edit_definition().model.inelastic = true;
        world.edit_definition().kinds[0].restitution = 0.0;
        world.edit_definition().kinds[0].friction = 0.5;
        world.edit_definition().materials[0].restitution = 0.0;
        world.edit_definition().materials[0].friction = 0.5;
        left = add_capsule(world, {{-10.0, 10.0}, {0.0, 0.0}, 0.0}, 0);
        add_capsule(world, {{0.0, 0.0}, {10.0, 10.0}, 0.0}, 0);
        add_ball(world, {.position = {0.0, std::sqrt(2.0)}, .spin = spin});
    }
};

}  // namespace

TEST_CASE("event: a ball whose spin has been braked still rests on its supports") {
    Groove groove(1.0);
    Solver solver({.kind = SolverKind::event});
    for (int tick = 0; tick < 20; ++tick)
        solver.tick(groove.world);
    REQUIRE(groove.world.balls().spin[0] == 0.0);
    const StoredTrajectories braked = event_memory(groove.world).trajectories;
    CHECK(braked.lines[0].motion == Motion::resting);
    CHECK(braked.curves[0].support.kind == SupportId::Kind::edge);
    CHECK(braked.curves[0].second_support.kind == SupportId::Kind::edge);
    for (int tick = 0; tick < 600; ++tick)
        solver.tick(groove.world);
    CHECK(event_memory(groove.world).trajectories.lines[0].time == braked.lines[0].time);
}

TEST_CASE("event: a ball whose spin has been braked falls at once when a support is taken away") {
    for (const double spin : {0.0, 1.0}) {
        CAPTURE(spin);
        Groove groove(spin);
        Solver solver({.kind = SolverKind::event});
        for (int tick = 0; tick < 600; ++tick)
            solver.tick(groove.world);
        const Vec2 before = groove.world.balls().position[0];
        remove_capsule(groove.world, groove.left);
        solver.tick(groove.world);
        CHECK(groove.world.balls().position[0].x < before.x);
    }
}
