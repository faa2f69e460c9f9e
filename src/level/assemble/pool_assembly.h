#pragma once

#include "level/assemble/assemble.h"
#include "level/assemble/resolve_names.h"
#include "level/scene/scene.h"

/// What is wrong with a pool table, and what of it the scene has.
namespace carom {

/// Reports cloth that does not go with other physics, pockets that are too small, games without
/// what they need.
void check_pool(const std::vector<StartingBall>& balls, const LoadOptions& options,
                Context& context);

/// Fills in Scene::pool; reports a cue for a ball that is not there. Pre: checked, without errors;
/// the scene has its balls and their names, and its zones. `world_zones`: by LevelIr::zones, the
/// index into World::zones.
void fill_in_pool(const std::vector<StartingBall>& balls,
                  const std::vector<std::uint32_t>& world_zones, Scene& scene, Context& context);

}  // namespace carom
