#pragma once

#include <cstdint>

#include "physics/world/world.h"

namespace carom {

/// Perturbs a start: moves every ball by a random offset of at most `size` along each axis. The
/// offset depends on `seed`, `copy` and the ball alone. Balls that touched may overlap by that
/// much.
void nudge(World& world, double size, std::uint64_t seed, std::uint64_t copy);

}  // namespace carom
