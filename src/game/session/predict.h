#pragma once

#include <cstdint>
#include <vector>

#include "physics/solver.h"
#include "physics/world/world.h"

namespace carom {

/// Where a ball would go if it were struck now: its place after each of the next `ticks` ticks,
/// beginning with where it is. The engine itself, run ahead on a copy, so it is right to the last
/// bit unless somebody acts before. Shorter where the ball is lost in a sink; empty when there is
/// no such ball.
std::vector<Vec2> predicted_path(const World& world, const SolverSettings& solver, BallId ball,
                                 Vec2 velocity, std::uint64_t ticks);

}  // namespace carom
