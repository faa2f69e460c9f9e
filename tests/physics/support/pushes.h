#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "physics/solver.h"
#include "physics/world/world.h"

/// Random pushes: a hand drives an edge or a ball through a row, a heap or a bucket, and what came
/// of it is measured from positions, velocities and shapes alone, and from the impulses on the
/// hand that the solver reports.
namespace carom::pushes {

/// A hand that goes straight on at a constant speed, waits, and goes back a little.
struct Push {
    World world;
    double restitution = 0.5;
    std::vector<CapsuleId> edges;  ///< that hands move
    std::vector<Vec2> ways;        ///< of these, in all
    double speed = 1.0;            ///< length/s
    int ticks = 0;                 ///< in which they go there
    std::string name;
};

/// The push of this number. Equal numbers make equal pushes.
Push random_push(std::uint64_t number, bool with_cloth);

/// What became worst in a push, over all ticks.
struct Result {
    int passed = 0;        ///< balls that came to the wrong side of an edge, or out of the walls
    double gain = 0.0;     ///< of energy beyond the work of the hands, as a share of the total
    double speed = 0.0;    ///< of the fastest ball, as a share of what may be
    double overlap = 0.0;  ///< deepest, in radii
    double without = 0.0;  ///< deepest without a push
    double lag = 0.0;      ///< how far the hands are from their targets at the end, length
    int ticks = 0;
};
Result run(const Push& push, SolverKind kind, bool is_measured_without);

}  // namespace carom::pushes
