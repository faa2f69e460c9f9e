#pragma once

#include "physics/world/world.h"

/// How a tick of `swept` is divided into substeps.
namespace carom {

/// `substeps` of `duration` each, and then the rest of the tick, in one substep in which time
/// stands still for every far ball.
struct SweptDivision {
    int substeps = 1;
    double duration = 0.0;  ///< s
    double rest = 0.0;      ///< s; usually 0
};

/// The division of a tick for which so many substeps are asked.
///
/// Paths that cross the whole scene make every ball a candidate of every other one: n^2 / 2 pairs
/// when the substep begins, and n more after each impact. So a tick has as many substeps that no
/// more than `most_far_balls` go far in one of them, which is further than `far` of their own
/// radii. If that would take more than `most_substeps`, time stands still for far balls in the
/// rest. The numbers are those of tolerances.h. Cost: O(n). Pre: asked >= 1.
SweptDivision divide_tick(const World& world, int asked);

/// Whether a ball that goes this far, a length, goes far.
bool is_far(double path, double radius);

}  // namespace carom
