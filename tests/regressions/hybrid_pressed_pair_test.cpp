#include <doctest/doctest.h>

#include "physics/event/motion/event_memory.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"

// In a hybrid step of the solver `event`, the contacts of the tick before decided which balls stay
// in the cluster. Two balls of which one pressed on the other left it after one tick, unless all
// balls of the scene belonged to it; and two that no longer pressed stayed for a tick too long.

using namespace carom;

namespace {

// Two large balls stand on each other, and a third stands beside them out of reach, which `event`
// advances.
struct Stack {
    World world = scenes::empty();

    explicit Stack(Vec2 velocity_of_upper) {
        world.edit_definition().rate = 120.0;
        world.edit_definition().model.gravity = Vec2{0.0, -1.0};
        world.edit_definition().model.inelastic = true;
        world.edit_definition().kinds[0] = {.radius = 10.0, .mass = 1.0, .restitution = 0.0};
        world.edit_definition().materials[0].restitution = 0.0;
        add_capsule(world, {{-100.0, -1.0}, {100.0, -1.0}, 1.0}, 0);
        add_ball(world, {.position = {0.0, 10.0}});
        add_ball(world, {.position = {0.0, 30.0}, .velocity = velocity_of_upper});
        add_ball(world, {.position = {80.0, 10.0}});
        edit_event_memory(world).clustered = {BallId{0}, BallId{1}};
    }
};

}  // namespace

TEST_CASE("hybrid step: balls that press on each other in the tick stay in the cluster") {
    Stack stack({0.0, 0.0});
    Solver solver({.kind = SolverKind::event});
    for (int tick = 0; tick < 4; ++tick) {
        CAPTURE(tick);
        solver.tick(stack.world);
        CHECK(event_memory(stack.world).clustered.size() == 2);
    }
}

TEST_CASE("hybrid step: balls that pressed on each other a tick ago leave the cluster") {
    Stack stack({0.0, 5.0});
    edit_event_memory(stack.world)
        .contacts.push_back(
            {.ball = BallId{0}, .other = 1, .kind = ContactKind::ball_ball, .impulse = 1e-3});
    Solver solver({.kind = SolverKind::event});
    solver.tick(stack.world);
    CHECK(event_memory(stack.world).clustered.empty());
}
