#include "physics/discrete/kinematics.h"

#include <algorithm>

#include "physics/world/solver_access.h"

namespace carom {

void OverlapKinematics::begin_tick(const World& world) {
    inverse_mass_ = world.balls().inverse_mass;
    if (world.held_balls().empty()) return;
    with_held_balls_ = world.balls().inverse_mass;
    make_held_balls_immovable(world, with_held_balls_);
    inverse_mass_ = with_held_balls_;
}

void OverlapKinematics::move(World& world, double share, double duration) {
    longest_displacement_ = 0.0;
    for (const HeldBall& held : world.held_balls()) {
        const auto index = index_of(world, held.id);
        if (!index) continue;
        Vec2& position = SolverAccess(world).balls().position[*index];
        const Vec2 displacement = displacement_to_target(world, held, position) * share;
        position += displacement;
        longest_displacement_ = std::max(longest_displacement_, length(displacement));
        SolverAccess(world).balls().velocity[*index] = {};
    }
    list_kinematic_edges(world, edges_);
    for (HeldEdge& edge : edges_) {
        const HeldCapsule& held = world.held_capsules()[edge.held];
        Capsule& shape = SolverAccess(world).capsules().shape[edge.capsule];
        const Vec2 start = (held.start_target - shape.start) * share;
        const Vec2 end = (held.end_target - shape.end) * share;
        edge.start_velocity = start / duration;
        edge.end_velocity = end / duration;
        shape.start += start;
        shape.end += end;
    }
}

}  // namespace carom
