#pragma once

#include <span>
#include <vector>

#include "physics/world/contact.h"
#include "physics/world/world.h"

namespace carom {

/// The greatest speed of each ball in a tick, as far as it began with it or its contacts in the
/// tick have given it, length/s: without gravity, friction, and contacts that were not reported. By
/// place in `ids`.
///
/// `ids`, `velocity`: of the balls when the tick began, by ascending id. `contacts`: those of the
/// tick, in the order of time. Balls that the tick has removed keep the speed that they began with.
std::vector<double> fastest_within(const World& world, std::span<const Contact> contacts,
                                   std::span<const BallId> ids, std::span<const Vec2> velocity);

}  // namespace carom
