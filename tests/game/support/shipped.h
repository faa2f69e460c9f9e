#pragma once

#include <string>
#include <string_view>

#include "level/scene/scene.h"

namespace carom::test {

/// Loads a shipped level by name: "eight-ball".
Scene shipped_level(const std::string& name);

/// The ball of that name, which must exist.
BallId named(const Scene& scene, std::string_view name);

}  // namespace carom::test
