#pragma once

#include <cstddef>

#include "physics/world/world.h"

/// Worlds for tests, built without the level language.
namespace carom::scenes {

/// No balls, no edges, one kind (radius 1, mass 1, elastic) and one elastic material.
World empty();

/// Four capsules of radius 1 around `box`, outside it, so that its inside is free. Material 0.
void add_walls(World& world, const Box& box);

/// `count` elastic balls of radius 1 and mass 1 at packing 0.3 in a square box from the origin, on
/// a jittered lattice, with random velocities of RMS speed 10. No walls on a torus.
World gas(std::size_t count, std::uint64_t seed, bool torus = false);

/// A bucket 20 wide and 60 high with `count` balls of radius 0.5 on a lattice above its floor,
/// gravity 10.
World bucket(std::size_t count, double restitution);

/// Two blocks and a wall: a ball of mass `ratio` moves at speed 1 towards a resting one of mass 1
/// in front of a wall.
World blocks(double ratio);

/// Newton's cradle without strings: `count` balls in a row, `gap` apart, the first `in` of them at
/// speed 1.
World cradle(std::size_t count, std::size_t in, double gap);

}  // namespace carom::scenes
