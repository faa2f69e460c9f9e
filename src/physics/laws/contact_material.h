#pragma once

#include <algorithm>

#include "physics/laws/bounce.h"
#include "physics/world/solver_access.h"
#include "physics/world/world.h"

/// The material of a contact: restitution, friction, scatter and kicks of a pair, by the indices of
/// its bodies in the world. Solvers take them from here and nowhere else.
namespace carom {

/// Restitution of two balls: the smaller of theirs. 1 where nothing in the scene loses energy.
inline double restitution_of_balls(const World& world, std::size_t a, std::size_t b) {
    if (!world.model().inelastic) return 1.0;
    return std::min(world.balls().restitution[a], world.balls().restitution[b]);
}

/// Restitution of a ball that meets an edge at the speed `approach` (>= 0, length/s): that of the
/// edge's material, which may soften with speed. The ball's own does not count.
inline double restitution_of_edge(const World& world, std::size_t capsule, double approach) {
    if (!world.model().inelastic) return 1.0;
    return restitution_at(world.materials()[world.capsules().material[capsule]], approach);
}

/// Coefficient of friction of two balls. Pre: Model::spin.
inline double friction_of_balls(const World& world, std::size_t a, std::size_t b) {
    return friction_between(world.kinds()[world.balls().kind[a]],
                            world.kinds()[world.balls().kind[b]]);
}

/// Coefficient of friction of an edge. Pre: Model::spin.
inline double friction_of_edge(const World& world, std::size_t capsule) {
    return world.materials()[world.capsules().material[capsule]].friction;
}

/// The normal along which a ball bounces off an edge: `normal`, turned at random. Counts as one
/// more of the ball's `edge_contacts`. Pre: Model::scatter.
inline Vec2 bounce_normal(const World& world, std::size_t ball, std::uint32_t& edge_contacts,
                          Vec2 normal, Vec2 velocity, double restitution) {
    return scattered_normal(world, world.balls().id[ball], edge_contacts++, normal, velocity,
                            restitution);
}
/// For any scene, and for solvers that count in the world's own column: `normal` where the scene
/// does not scatter.
inline Vec2 bounce_normal(World& world, std::size_t ball, Vec2 normal, Vec2 velocity,
                          double restitution) {
    if (!world.model().scatter) return normal;
    return bounce_normal(world, ball, SolverAccess(world).balls().edge_contacts[ball], normal,
                         velocity, restitution);
}

/// What an edge that kicks adds along the normal, length/s. `shape` is where the edge is now,
/// `point` the ball's centre or the point of contact.
inline double kick_of_edge(const World& world, std::size_t capsule, const Capsule& shape,
                           Vec2 point, double approach) {
    if (!world.model().kicks) return 0.0;
    return kick_at(world.materials()[world.capsules().material[capsule]], shape, point, approach);
}

}  // namespace carom
