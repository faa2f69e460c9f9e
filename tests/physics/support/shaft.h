#pragma once

#include <cstdint>

#include "physics/world/world.h"

namespace carom::scenes {

/// A shaft, or a wider bin, in which a column of 3 to 62 balls falls or lies: restitution from 0.3
/// to 1, masses up to 1,000 times apart, some with friction. The floor is at a height of 0.
World shaft(std::uint64_t number);

}  // namespace carom::scenes
