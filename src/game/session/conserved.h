#pragma once

#include "physics/world/world.h"

/// Which sums physics keeps in this world from now on, so that a change of them is an error of the
/// solver and not of the scene.
namespace carom {

/// Kinetic and potential energy together: nothing takes it (losses, drag, limits), nothing brings
/// it (emitters, hands), nothing carries it away (sinks), and its potential part has one value
/// everywhere (no gravity on a torus).
bool keeps_energy(const World& world);

/// Momentum: as energy, but losses between balls keep it, and edges that balls meet and gravity do
/// not.
bool keeps_momentum(const World& world);

}  // namespace carom
