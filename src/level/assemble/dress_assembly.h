#pragma once

#include "level/assemble/assemble.h"
#include "level/assemble/resolve_names.h"
#include "level/scene/scene.h"

/// Assembles the dress of a level: the colour of each thing, and what is painted on the board.
namespace carom {

/// Sets Scene::dress, but for the devices of pinball tables. `world_zones` has the index into
/// World::zones for each of LevelIr::zones. Balls and kinds and materials whose name is that of a
/// colour have this colour, unless `color=` says otherwise. Pre: the scene's world has all balls,
/// capsules and zones; its names are filled in.
void fill_in_dress(const std::vector<StartingBall>& balls, const ResolvedNames& names,
                   const std::vector<std::uint32_t>& world_zones, Scene& scene, Context& context);

}  // namespace carom
