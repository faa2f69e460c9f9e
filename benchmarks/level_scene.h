#pragma once

#include <string>
#include <vector>

#include "level/scene/scene.h"
#include "scene_list.h"

/// From a level file, by carom's own loader, to what every engine can read.
namespace carom::bench {

struct LoadedScene {
    std::optional<Scene> scene;
    std::string error;  ///< where there is no scene: what is wrong, in one line
};
/// `overrides`: statements that take the place of the file's, as under `carom run --set`.
LoadedScene load_scene(const std::string& path, const std::vector<std::string>& overrides);

/// The balls (those of emitters too, each at the tick at which it would come if its place were
/// free), the edges and the terms of `world`. None, with an `error`, where the world has what the
/// list cannot say: terms other than gravity, restitution and spin, zones that swallow, or contacts
/// that differ in restitution or friction.
struct ListedScene {
    std::optional<SceneList> list;
    std::string error;
};
ListedScene list_of(const World& world, const RunPlan& plan);

}  // namespace carom::bench
