#pragma once

#include "physics/tick/solver_settings.h"
#include "physics/world/world.h"

/// What a solver will cost in a scene, and how far it will be off, estimated from the scene alone:
/// no clock is read, so that `auto` decides the same everywhere.
namespace carom {

/// What the estimates need to know of a scene.
struct Load {
    double balls = 0.0;        ///< with those that emitters will add
    double speed = 0.0;        ///< typical, length/s: of the start, and of a fall through the scene
    double radius = 1.0;       ///< mean
    double path = 0.0;         ///< mean free path between two impacts of a ball, a length
    double hits = 0.0;         ///< impacts of a ball a second, as in a dilute gas of these balls
    double rest = 0.0;         ///< share of the first 10 s in which balls lie on one another, 0..1
    double depth = 0.0;        ///< of the heap, 0..1: 1 is four layers or more
    bool is_straight = false;  ///< free paths are straight lines
    bool is_curved = false;    ///< paths are no parabolas: drag or a speed limit
    bool is_special = false;   ///< collision filters, kicks or one-way edges
    bool is_one_way = false;
};
Load load_of(const World& world);

/// Work of a tick, in operations. Calibrated so that one is about a nanosecond of one core in
/// docs/performance.md: only ratios matter, except to `budget`.
double predicted_work(const SolverSettings& solver, const World& world, const Load& load);

/// RMS error of a position after `time` s, in radii. A difference grows at every impact by about
/// the mean free path over the radius. `event` starts from rounding; so do `swept` and `contact` on
/// straight paths, and elsewhere from the g h^2 / 8 by which a substep of h seconds misjudges an
/// impact. `discrete` and `substep` start from the displacement of a ball in a step.
double predicted_error(const SolverSettings& solver, const World& world, const Load& load,
                       double time);

}  // namespace carom
