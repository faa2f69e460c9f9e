#pragma once

#include <string>
#include <string_view>

#include "level/scene/scene.h"

namespace carom::test {

/// A level that ships, by name: "eight-ball".
Scene shipped_level(const std::string& name);

/// The ball of that name, which must be there.
BallId named(const Scene& scene, std::string_view name);

}  // namespace carom::test
