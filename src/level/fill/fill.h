#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "level/fill/box_tree.h"
#include "level/ir/context.h"

/// Places the balls of `fill` statements at random.
namespace carom {

struct FilledBall {
    Vec2 position;
    Vec2 velocity;
    double radius = 1.0;
    double mass = 1.0;
};

/// Shapes that the balls of a fill must not overlap.
struct Obstacles {
    std::vector<Disc> discs;
    std::vector<Capsule> capsules;
    bool each_other = true;  ///< the balls must not overlap each other either
};

struct FillObstacles {
    /// Everything that is already in the level.
    const Obstacles& all;
    /// Makes the part of `all` that collides with the balls. Absent: all of it does.
    std::function<Obstacles()> solid;
};

/// Defaults of a fill, from the kind of its balls.
struct FillDefaults {
    double radius = 1.0;
    std::optional<double> mass;
    double density = 1.0;
};

/// Places the balls of a fill inside its box, so that they overlap neither each other nor the
/// obstacles. If they do not fit, tries again with only the solid obstacles. None: they still do
/// not fit, which is reported.
///
/// Larger balls come first; each takes the first free one of 300 random positions. If a ball finds
/// none (at packings above about 0.5), or the search has used half of the work that is left to the
/// level (LoadBudget), all balls go on a lattice instead, with random shifts as far as there is
/// room. Placement fails only if the densest lattice has too few sites. After the first fill that
/// fails none is placed, since it would be placed among others than the author meant.
///
/// The random numbers of ball i depend on the seed, the number of the fill and i alone. A velocity
/// has a speed from a range and a random direction. With rms=, velocities are Gaussian, truncated
/// at 8 standard deviations, and scaled so that their root mean square is exactly the given value.
///
/// 1,000,000 balls at a packing of 0.3 take about half a second.
std::optional<std::vector<FilledBall>> place_fill(const FillIr& fill, const FillDefaults& defaults,
                                                  const FillObstacles& obstacles, Context& context);

}  // namespace carom
