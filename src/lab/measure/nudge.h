#pragma once

#include <cstdint>

#include "physics/world/world.h"

namespace carom {

/// Moves every ball by a random offset of at most `size` each way, the same for the same `seed`,
/// `copy` and ball: a start that is a hair different. Balls that touched may overlap by a hair.
void nudge(World& world, double size, std::uint64_t seed, std::uint64_t copy);

}  // namespace carom
