#pragma once

#include <cstdint>
#include <string>

#include "physics/world/world.h"

namespace carom {

/// Which fingerprint a carom of today computes. Recordings name the version that they were marked
/// with; all earlier versions can still be computed, so every recording can be verified.
///
/// 1: ids, positions, velocities, radii, masses, shapes of edges, what is held, and most of what
///    solvers remember.
/// 2: all columns of balls and edges, so also the kind (the layer) and the restitution of a ball,
///    the material and the side of an edge, and what solvers remember, but for
///    StoredTrajectories::obstacles.
///
/// docs/determinism.md says when to raise it.
inline constexpr int fingerprint_version = 2;

/// 64 bits over the state that ticks and commands change: the number of the tick, bodies, kinematic
/// targets, flippers, emitters, counters of sinks, gravity, and solver memory. Not in it: what a
/// level fixes for good (kinds, materials, the rest of the model), how hands have moved
/// (World::hands), the next ids, the list of removed balls, the numbers of collisions, and that the
/// model has become lossy or one_way, which shows in the columns. Worlds that are equal have equal
/// fingerprints on every machine; two that differ in what is in it share one with a chance of about
/// 2^-64. Stamps are no part of it. Cost: one multiplication for each number in the world. Pre:
/// version is in 1..fingerprint_version.
std::uint64_t fingerprint(const World& world, int version = fingerprint_version);

/// 16 lower-case hexadecimal digits.
std::string hexadecimal(std::uint64_t fingerprint);

}  // namespace carom
