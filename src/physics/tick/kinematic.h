#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/shapes.h"
#include "physics/world/world.h"

/// Kinematic bodies within a tick: the balls and edges that a player holds, and flippers. They go
/// where they are wanted, whatever the forces; solvers that stop them do so through `share` and
/// `stopped_at`.
namespace carom {

/// An edge that a player holds or a solenoid drives, in a substep.
struct HeldEdge {
    std::uint32_t capsule = 0;  ///< index in the world
    std::uint32_t held = 0;     ///< index into World::held_capsules
    bool is_driven = false;     ///< throws what it meets, like a wall that moves
    Vec2 start_velocity;        ///< wanted velocities of its ends, length/s
    Vec2 end_velocity;
    double share = 1.0;         ///< of these that it goes at
    double stopped_at = -1.0;   ///< s in the substep; negative: it moves
    std::uint32_t version = 0;  ///< grows when it stops, so that predictions become void

    bool is_stopped() const { return stopped_at >= 0.0; }
};

/// All held and driven edges, at rest, in the order of World::held_capsules. One whose capsule is
/// gone is left out.
void list_kinematic_edges(const World& world, std::vector<HeldEdge>& edges);

/// Sets the velocities with which the edge goes `per_second` (1/s) of the rest of its way in a
/// second, from where it is in the world.
void aim(HeldEdge& edge, const World& world, double per_second);

/// The edge of this capsule, or null. There are few, so this is a linear search.
HeldEdge* find_edge(std::span<HeldEdge> edges, std::uint32_t capsule);
const HeldEdge* find_edge(std::span<const HeldEdge> edges, std::uint32_t capsule);

/// Where the edge is `now` seconds into the substep. In the world it is where the substep began.
Capsule shape_at(const HeldEdge& edge, const World& world, double now);

/// Velocity of the edge at the place of its spine that is nearest to `point`; 0 once it has
/// stopped. `shape` is where the edge is at that time.
Vec2 surface_velocity(const HeldEdge& edge, const Capsule& shape, Vec2 point);

/// How far a held ball at `position` still has to go: on a torus the shortest way.
Vec2 rest_of_way(const World& world, const HeldBall& held, Vec2 position);

/// Sets the inverse mass of held balls to 0. `inverse_mass` is by ball.
void make_held_balls_immovable(const World& world, std::vector<double>& inverse_mass);

}  // namespace carom
