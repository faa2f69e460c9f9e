#pragma once

#include "physics/world/world.h"

/// The conserved quantities, and how deep bodies overlap.
namespace carom {

/// Sums over all balls, and over seesaws, whose centres of mass never move. Kinetic energy and
/// angular momentum include spin where balls spin.
/// Potential energy is that of gravity, 0 at the origin; angular momentum is about the origin.
/// Units: mass, length and s of the level.
struct Totals {
    double kinetic_energy = 0.0;
    double potential_energy = 0.0;
    Vec2 momentum;
    double angular_momentum = 0.0;

    double energy() const { return kinetic_energy + potential_energy; }
};
Totals totals(const World& world);

/// How far balls travel in a tick, in radii: the RMS speed times the tick over the RMS radius. NaN
/// where no ball moves and none has a size; infinite where balls without a size move.
double typical_travel_in_radii(const World& world);

/// Depth of the deepest overlap between bodies that collide, a length; 0 when nothing overlaps.
/// Covers ball against ball and ball against edge, held balls included; on a torus the nearest
/// images.
double deepest_overlap(const World& world);

}  // namespace carom
