#include <cmath>

#include <doctest/doctest.h>

#include "physics/event_engine.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"

// How long the solver `event` looks for impacts where no closed form finds them.

using namespace carom;

namespace {

// An edge in a hand that sweeps, with its other end as a pivot, from one side of it to the other in
// one tick, and a ball that all but touches it at the pivot: for half of the tick the two are a
// hair apart, which the bound on what the edge does there takes for nearly an impact.
World sweeping() {
    World world = scenes::empty();
    world.rate = 1.0;
    add_ball(world, {.position = {-0.5 - 1e-11, 0.0}, .radius = 0.5});
    const CapsuleId edge = add_capsule(world, {{0.0, 0.0}, {10.0, 0.0}, 0.0}, 0);
    world.held_capsules = {{edge, {0.0, 0.0}, {-10.0, 1.0}}};
    return world;
}

}  // namespace

// It was left off after a million looks, as one that finds nothing: the edge went through the ball.
TEST_CASE("event: what a long search looks for is met") {
    World world = sweeping();
    Solver solver({.kind = SolverKind::event});
    CHECK(solver.tick(world) == TickOutcome::done);
    REQUIRE(!solver.contacts().empty());
    CHECK(solver.contacts().front().time == doctest::Approx(0.5).epsilon(1e-3));
    CHECK(world.balls.velocity[0].y < -1.0);
}

// Nobody was asked before the search had ended.
TEST_CASE("event: a tick that searches long can be given up") {
    World world = sweeping();
    Solver solver({.kind = SolverKind::event});
    int asked = 0;
    CHECK(solver.tick(world, [&] { return ++asked < 10; }) == TickOutcome::given_up);
    CHECK(asked == 10);
    CHECK(world.tick == 0);
    CHECK(solver.tick(world) == TickOutcome::done);
    World straight = sweeping();
    Solver(SolverSettings{.kind = SolverKind::event}).tick(straight);
    CHECK(world.balls.velocity == straight.balls.velocity);
    CHECK(world.balls.position == straight.balls.position);
}
