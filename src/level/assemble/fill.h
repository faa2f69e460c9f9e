#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "level/assemble/box_tree.h"
#include "level/ir/context.h"

/// Balls placed by chance: `fill`.
namespace carom {

struct FilledBall {
    Vec2 position;
    Vec2 velocity;
    double radius = 1.0;
    double mass = 1.0;
};

/// What the balls of a fill keep clear of.
struct Obstacles {
    std::vector<Disc> discs;
    std::vector<Capsule> capsules;
    bool each_other = true;
};

struct FillObstacles {
    /// All that stands there.
    const Obstacles& all;
    /// Makes those of them that the balls may not overlap: what they meet, by `collide`. Absent:
    /// they are all.
    std::function<Obstacles()> solid;
};

/// What a fill takes from its kind where it says nothing itself.
struct FillDefaults {
    double radius = 1.0;
    std::optional<double> mass;
    double density = 1.0;
};

/// Places the balls of a fill: wholly inside its box, overlapping neither each other nor the
/// obstacles. When they do not fit, only what is solid to them is in their way; when they still do
/// not, none, and a message.
///
/// The larger balls are placed first, each at the first free of 300 random places. When one finds
/// none (from a packing of about 0.5 on), all stand on a lattice instead, shifted at random as far
/// as it leaves room: so it never hangs, and fails only where the densest lattice fails too, or
/// where all fills together have looked at obstacles 200 million times.
/// Ball number i of a fill draws from the seed, the number of the fill and i alone. Speeds come
/// either of one size in a random direction, or (rms=) from a Gaussian, cut at 8 standard
/// deviations, and then scaled so that their root mean square is exactly the one given.
///
/// 1,000,000 balls at a packing of 0.3 take about a second.
std::optional<std::vector<FilledBall>> place_fill(const FillIr& fill, const FillDefaults& defaults,
                                                  const FillObstacles& obstacles, Context& context);

}  // namespace carom
