#pragma once

#include <string>

#include "level/scene.h"

namespace carom::test {

/// A level that ships, by name: "eight-ball".
Scene shipped_level(const std::string& name);

}  // namespace carom::test
