#pragma once

#include <cstddef>

#include "physics/world/world.h"

namespace carom {

/// Whether the edge blocks all balls of that kind, from both sides, and is where it was: neither
/// held, nor a flipper, nor moving by itself.
bool is_wall(const World& world, std::size_t edge, ClassIndex kind);

/// From a point to the spine of an edge.
double distance_to_segment(Vec2 point, const Capsule& edge);

}  // namespace carom
