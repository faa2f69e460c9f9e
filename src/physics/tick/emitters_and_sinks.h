#pragma once

#include <cstdint>
#include <vector>

#include "physics/world/world.h"

/// What happens at the two ends of every tick, whatever the solver: births, stops and sinks.
namespace carom {

/// Emitters give birth to the balls whose time comes in the tick that begins.
void emit(World& world);

/// Balls slower than the stop speed stop; those that turn, when their rims are slower too.
/// `touched`: by index, whether the ball met something in this tick; under gravity only those stop.
void stop_slow_balls(World& world, const std::vector<std::uint8_t>& touched);

/// Counts and removes the balls in sinks. `world.tick` is the tick that ends.
void drain_sinks(World& world);

/// How many substeps a tick needs, `wanted` or more: on a torus each must be so short that no ball
/// meets two images of another in it, an eighth of the torus at most. 10,000 at most.
int substeps_needed(const World& world, int wanted);

}  // namespace carom
