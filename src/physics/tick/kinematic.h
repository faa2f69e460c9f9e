#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/shapes.h"
#include "physics/world/world.h"

/// Kinematic bodies within a tick: the balls and edges that a player holds, flippers and movers.
/// They move to their targets whatever the forces. A solver slows one with `share` and stops it
/// with `stopped_at`.
namespace carom {

/// An edge that a player holds or a solenoid drives, or that of a seesaw, as it moves in one
/// substep.
struct HeldEdge {
    std::uint32_t capsule = 0;  ///< index in the world
    std::uint32_t held = 0;     ///< index into World::held_capsules
    bool is_driven = false;     ///< motorised: throws what it hits, like a moving wall
    Vec2 start_velocity;        ///< target velocities of its ends, length/s
    Vec2 end_velocity;
    double share = 1.0;         ///< of the target velocities, at which it moves
    double stopped_at = -1.0;   ///< s into the substep; negative: it still moves
    std::uint32_t version = 0;  ///< incremented when it stops, so that predictions become void

    bool is_seesaw = false;
    Seesaw seesaw;  ///< as it is `since` s into the substep; then it turns at its rate
    double since = 0.0;

    bool is_stopped() const { return stopped_at >= 0.0; }
    /// The seesaw `now` s into the substep, if nothing hits it from `since` on.
    Seesaw seesaw_at(double now) const;
    /// When it comes to its stop, s into the substep; infinite if it does not.
    double time_of_stop() const;
    /// From `now` on it is this seesaw: something has hit it.
    void turn(const Seesaw& hit, double now) {
        seesaw = hit;
        since = now;
        ++version;
    }
    /// Stops it `now` seconds into the substep. A seesaw keeps its rate for the next one.
    void stop(double now) {
        stopped_at = now;
        ++version;
    }
};

/// All held and driven edges, with velocity 0, and the edges of seesaws as they are in the world,
/// in the order of World::held_capsules. An entry whose capsule no longer exists is left out.
void list_kinematic_edges(const World& world, std::vector<HeldEdge>& edges);

/// When the first seesaw comes to its stop, s into the substep; infinite if none does.
double first_stop(std::span<const HeldEdge> edges);

/// The seesaws that come to their stops `now` s into the substep bounce, and get new versions.
void bounce_at_stops(std::span<HeldEdge> edges, double now);

/// Ends a substep of `duration` s for the edge: writes its place, and that of its seesaw, to the
/// world.
void finish(const HeldEdge& edge, World& world, double duration);

/// Sets the velocities that would take the edge from its place in the world to its target in
/// 1 / `per_second` seconds.
void aim(HeldEdge& edge, const World& world, double per_second);

/// The edge of this capsule, or null. There are few, so this is a linear search.
HeldEdge* find_edge(std::span<HeldEdge> edges, std::uint32_t capsule);
const HeldEdge* find_edge(std::span<const HeldEdge> edges, std::uint32_t capsule);

/// Where the edge is `now` seconds into the substep. The world holds its place at the start of the
/// substep.
Capsule shape_at(const HeldEdge& edge, const World& world, double now);

/// Velocity of the edge at the point of its spine nearest to `point`, length/s; 0 once it has
/// stopped. `shape` is the edge at that time.
Vec2 surface_velocity(const HeldEdge& edge, const Capsule& shape, Vec2 point);

/// Whether a ball that went from `from` to `to`, while an edge went from `was` to `is`, has changed
/// sides: it was beside the spine, and is on its other side.
bool has_crossed(const Capsule& was, const Capsule& is, Vec2 from, Vec2 to);

/// Displacement of a held ball at `position` to its target; on a torus the shortest.
Vec2 displacement_to_target(const World& world, const HeldBall& held, Vec2 position);

/// Sets the inverse mass of held balls to 0. `inverse_mass` is by ball.
void make_held_balls_immovable(const World& world, std::vector<double>& inverse_mass);

}  // namespace carom
