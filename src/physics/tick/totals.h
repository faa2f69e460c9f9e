#pragma once

#include "physics/world/world.h"

/// The quantities that physics keeps, and how deep bodies are in each other.
namespace carom {

/// Sums over all balls. Where balls turn, kinetic energy and angular momentum count that. Potential
/// energy is that of gravity, 0 at the origin; angular momentum is about the origin. Units: mass,
/// length and s of the level.
struct Totals {
    double kinetic_energy = 0.0;
    double potential_energy = 0.0;
    Vec2 momentum;
    double angular_momentum = 0.0;

    double energy() const { return kinetic_energy + potential_energy; }
};
Totals totals(const World& world);

/// How far balls go in a tick, in radii: the root of the mean of the squares of either. Not a
/// number where none moves and none has a size; without bound where one of no size moves alone.
double typical_way(const World& world);

/// Depth of the deepest overlap between bodies that meet, a length; 0 when nothing overlaps. Counts
/// ball on ball and ball on edge; a held ball counts as any other. On a torus, over the nearest
/// images.
double deepest_overlap(const World& world);

}  // namespace carom
