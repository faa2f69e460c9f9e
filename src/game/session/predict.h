#pragma once

#include <cstdint>
#include <vector>

#include "physics/solver.h"
#include "physics/world/world.h"

namespace carom {

/// The path of a ball that is struck now: its present position and its position after each of the
/// next `ticks` ticks. The engine runs ahead on a copy, so the path is exact to the last bit unless
/// a command intervenes. Shorter if a sink removes the ball; empty if the ball does not exist.
std::vector<Vec2> predicted_path(const World& world, const SolverSettings& solver, BallId ball,
                                 Vec2 velocity, std::uint64_t ticks);

}  // namespace carom
