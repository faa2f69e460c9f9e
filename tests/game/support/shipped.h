#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "level/scene/scene.h"

namespace carom::test {

/// The names of all levels that ship and are games of pinball, in alphabetical order.
std::vector<std::string> pinball_tables();

/// Loads a shipped level by name: "eight-ball". `overrides`: statements of --set.
Scene shipped_level(const std::string& name, std::vector<std::string> overrides = {});

/// The ball of that name, which must exist.
BallId named(const Scene& scene, std::string_view name);

}  // namespace carom::test
