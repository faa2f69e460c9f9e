#pragma once

#include <string>
#include <vector>

#include "level/scene/scene.h"
#include "scene_list.h"

/// From a level file, through carom's loader, to a list that every engine can read.
namespace carom::bench {

struct LoadedScene {
    std::optional<Scene> scene;
    std::string error;  ///< in one line, where there is no scene
};
/// `overrides`: statements that replace the file's, as with `carom run --set`.
LoadedScene load_scene(const std::string& path, const std::vector<std::string>& overrides);

/// The balls, edges and terms of `world`. Emitted balls are included, each at the tick at which it
/// would appear if its place were free. None, with an `error`, where a list cannot describe the
/// world: terms other than gravity, restitution and spin, sinks, or contacts that differ in
/// restitution or friction.
struct ListedScene {
    std::optional<SceneList> list;
    std::string error;
};
ListedScene list_of(const World& world, const RunPlan& plan);

}  // namespace carom::bench
