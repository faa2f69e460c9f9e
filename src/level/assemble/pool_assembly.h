#pragma once

#include "level/assemble/assemble.h"
#include "level/assemble/resolve_names.h"
#include "level/scene/scene.h"

/// Checks and assembles a pool table.
namespace carom {

/// Reports cloth together with terms or solvers that exclude it, pockets smaller than a ball, and
/// games of pool without a rack, a cue or pockets.
void check_pool(const std::vector<StartingBall>& balls, const LoadOptions& options,
                Context& context);

/// Sets Scene::pool; reports a cue for an unknown ball. `world_zones` has the index into
/// World::zones for each of LevelIr::zones. Pre: checked without errors; the scene has its balls,
/// their names and its zones.
void fill_in_pool(const std::vector<StartingBall>& balls,
                  const std::vector<std::uint32_t>& world_zones, Scene& scene, Context& context);

}  // namespace carom
