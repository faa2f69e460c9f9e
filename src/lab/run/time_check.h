#pragma once

#include <optional>
#include <span>

#include "lab/run/breach.h"
#include "lab/run/promise.h"
#include "physics/world/world.h"

namespace carom {

/// The first ball that has a velocity and has stayed exactly where it was, though nothing holds it:
/// see InvariantCheck (invariants.h), of which this is a part.
///
/// `positions` and `velocities` are those before the tick, by index. Held balls do not count.
///
/// Where `contact` steps, iterations leave a pressed ball a velocity that it has not moved with. So
/// there a ball may stay if the velocity before the tick and that after it lead into bodies that it
/// touches, as one does that others press into a corner.
///
/// Pre: the world is no torus, and has the same balls as before the tick.
std::optional<Breach> find_ball_that_stays(const World& world, const Promise& promise,
                                           std::span<const Vec2> positions,
                                           std::span<const Vec2> velocities);

}  // namespace carom
