#pragma once

#include <cstdint>
#include <vector>

#include "physics/world/world.h"

/// What happens at the start and the end of every tick, whatever the solver: emitters, the stop
/// speed, and sinks.
namespace carom {

/// Adds the balls that emitters create in the tick that begins.
void emit(World& world);

/// Stops balls slower than the stop speed; a spinning ball only when its surface is slower too.
/// `touched`: by index, whether the ball had a contact in this tick, as the solver counts it
/// (TickWork::touched). Under gravity only balls with contacts stop.
void stop_slow_balls(World& world, const std::vector<std::uint8_t>& touched);

/// Counts and removes the balls in sinks. `world.tick` is the tick that ends.
void drain_sinks(World& world);

/// How many substeps a tick needs: `wanted` or more, at most 10,000. On a torus no ball may travel
/// more than an eighth of it in a substep, so that it cannot meet two images of another ball.
int substeps_needed(const World& world, int wanted);

}  // namespace carom
