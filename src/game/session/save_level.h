#pragma once

#include <string>

#include "level/scene/scene.h"
#include "physics/world/world.h"

namespace carom {

/// The present state as a level file: `world` is the scene's world as it is now.
///
/// load_level reads it back to a world that is equal bit by bit in its balls (position, velocity,
/// radius, mass, restitution, kind), its edges, its model, kinds, materials, seed and rate. The
/// title, the author's opening comment, the names, the colours and the display settings are kept.
///
/// A level starts at time 0, so some state is reset: time, counters and collision counts, the ids
/// of balls and edges (in the same order, without gaps), the random draws of scatter; emitters keep
/// the balls that they have yet to add. `expect` statements are left out, since they belong to
/// another start.
///
/// Levels with `units` are written in `units m`, whatever the author's unit was: conversion from it
/// is not exact.
std::string level_text(const Scene& scene, const World& world);

}  // namespace carom
