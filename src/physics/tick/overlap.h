#pragma once

#include <cstdint>

#include "physics/world/world.h"

/// How deep two bodies overlap, for the checks of a tick that pushes them (hands.h, mover_step.h).
namespace carom {

/// In radii of the smaller ball; negative: the distance between them. On a torus, of the nearest
/// images.
double relative_overlap(const World& world, std::uint32_t ball, std::uint32_t other);

/// In radii of the ball; negative: the distance between them. `edge`: on a torus, the image that is
/// meant.
double relative_overlap(const World& world, std::uint32_t ball, const Capsule& edge);

}  // namespace carom
