#pragma once

#include <string>

#include "level/scene/scene.h"
#include "physics/world/world.h"

namespace carom {

/// What stands, as a level file: `world` is what has become of the scene's world.
///
/// load_level reads it back to a world that is the same bit by bit in its balls (position,
/// velocity, radius, mass, restitution, kind), its edges, its model, kinds, materials, seed and
/// rate. The title, the author's opening comment, the names and what is shown are kept.
///
/// A level begins at time 0, so these begin anew: time, counters and counts of collisions, the
/// numbers of balls and edges (in the same order, without gaps), emitters (each with the balls that
/// it still has to give), the draws of scatter. `expect` statements are left out: they are about
/// another start.
///
/// Levels with `units` are written in `units m`, whatever the author's unit was: conversion from it
/// is not exact.
std::string level_text(const Scene& scene, const World& world);

}  // namespace carom
