#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "geometry/shapes.h"

/// Regular lattices of discs in a box.
namespace carom {

struct Lattice {
    std::vector<Vec2> sites;
    double pitch = 0.0;  ///< distance between neighbouring sites
};

/// The square or hexagonal lattice of widest pitch (within 2 %) with at least `count` open sites. A
/// disc of `radius` at a site lies in the box; `is_open` tells whether a site may be used. If no
/// lattice has enough sites, returns the one of pitch 2 radius that has more; it may have none.
/// Cost: examines at most 4 count + 1000 sites for each pitch that it tries, up to 40 pitches
/// (`is_open` may throw to stop it). Pre: radius > 0.
Lattice widest_lattice(const Box& box, double radius, std::size_t count,
                       const std::function<bool(Vec2)>& is_open);

}  // namespace carom
