#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "geometry/shapes.h"

/// Regular places for many discs in a box.
namespace carom {

struct Lattice {
    std::vector<Vec2> sites;
    double pitch = 0.0;  ///< distance between neighbouring sites
};

/// The lattice, square or hexagonal, of the widest pitch (within 2 %) that has at least `count`
/// sites that are open, each with room for a disc of `radius` inside the box. Looks at no more than
/// 4 count + 1000 sites at once. If none has enough, the one of pitch 2 radius with more sites, or
/// none at all. Pre: radius > 0.
Lattice widest_lattice(const Box& box, double radius, std::size_t count,
                       const std::function<bool(Vec2)>& is_open);

}  // namespace carom
