#pragma once

#include <algorithm>

#include "physics/contact/solver.h"

// Where a ball is on its path in a substep of the solver `contact`, and how it moves there, for the
// files that find impacts and deal with them.
namespace carom {

inline Vec2 ContactSolver::chord_position(std::uint32_t body, double now) const {
    const Path& path = path_of(body);
    return path.position + path.chord * (std::min(now, path.end) - path.time);
}

inline Vec2 ContactSolver::position_at(const World& world, std::uint32_t body, double now) const {
    const Path& path = path_of(body);
    const double since = std::min(now, path.end) - path.time;
    if (!path.free) return path.position + path.chord * since;
    return path.position + travel(flight_over(world.model.drag, since), path.velocity, gravity_);
}

inline Vec2 ContactSolver::velocity_at(const World& world, std::uint32_t body, double now) const {
    const Path& path = path_of(body);
    const double since = std::min(now, path.end) - path.time;
    if (!path.free) return path.velocity + path.pull * since;
    return velocity_after(flight_over(world.model.drag, since), path.velocity, gravity_);
}

inline double ContactSolver::rim_at(std::uint32_t body, double now) const {
    const Path& path = path_of(body);
    return path.rim + path.turn * (std::min(now, path.end) - path.time);
}

}  // namespace carom
