#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "level/scene/scene.h"

namespace carom::test {

/// Loads a shipped level by name: "eight-ball". `overrides`: statements of --set.
Scene shipped_level(const std::string& name, std::vector<std::string> overrides = {});

/// The ball of that name, which must exist.
BallId named(const Scene& scene, std::string_view name);

}  // namespace carom::test
