#pragma once

#include <cstdint>
#include <vector>

#include "physics/world.h"

/// What happens at the two ends of every tick, whatever the solver: births, stops and sinks.
namespace carom {

/// Emitters give birth to the balls whose time comes in the tick that begins.
void emit(World& world);

/// Balls slower than the stop speed stop; those that turn, when their rims are slower too.
/// `touched`: by index, whether the ball met something in this tick; under gravity only those stop.
void stop_slow_balls(World& world, const std::vector<std::uint8_t>& touched);

/// Counts and removes the balls in sinks. `world.tick` is the tick that ends.
void drain_sinks(World& world);

}  // namespace carom
