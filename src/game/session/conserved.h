#pragma once

#include "physics/world/world.h"

/// The sums that physics conserves in this world from now on, so that a change of them is an error
/// of the solver and not an effect of the scene.
namespace carom {

/// Whether kinetic plus potential energy is conserved: nothing dissipates it (`loses_energy`, a
/// speed limit), nothing adds it (emitters, dragged bodies), nothing removes it (sinks), and
/// potential energy is single-valued (no gravity on a torus).
bool conserves_energy(const World& world);

/// Whether momentum is conserved. The conditions are those of energy, except that restitution and
/// friction between balls are allowed, while gravity and edges that balls can hit are not.
bool conserves_momentum(const World& world);

}  // namespace carom
