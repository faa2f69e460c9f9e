#pragma once

#include <cstdint>
#include <string>

#include "physics/world/world.h"

namespace carom {

/// The version of the fingerprint that this program computes by default. A recording names the
/// version of its marks. All earlier versions can still be computed, so every recording can be
/// verified.
///
/// Version 1 covers ids, positions, velocities, radii, masses, spins, shapes of edges, what is held
/// and its targets, and most of the solver memory.
/// Version 2 covers all columns of balls and edges, so also the kind (with its layer) and the
/// restitution of a ball, and the material and the side of an edge; while something is held,
/// World::hands; and all of the solver memory except StoredTrajectories::obstacles. A column that
/// is younger than version 2 is covered where it is in use, so other worlds keep their
/// fingerprints.
///
/// docs/determinism.md says when to raise it.
inline constexpr int fingerprint_version = 2;

/// A 64-bit hash of the state that ticks and commands change: the number of the tick, bodies,
/// kinematic targets, hands, flippers, movers, emitters, counters of sinks, gravity, and solver
/// memory.
///
/// It leaves out what a level fixes for good (kinds, materials, the rest of the model); the next
/// ids, the list of removed balls and the counts of collisions; stamps; and the flags that edits
/// set in the model (inelastic, rough, one_way), whose effect is in the columns.
///
/// Equal worlds have equal fingerprints on every machine. Two worlds that differ in what is hashed
/// have the same fingerprint with a chance of about 2^-64. Cost: one multiplication for each number
/// in the world. Pre: version is in 1..fingerprint_version.
std::uint64_t fingerprint(const World& world, int version = fingerprint_version);

/// 16 lower-case hexadecimal digits.
std::string hexadecimal(std::uint64_t fingerprint);

}  // namespace carom
