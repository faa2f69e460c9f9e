#pragma once

#include <doctest/doctest.h>

#include <string>

#include "level/load.h"

namespace carom::test {

/// The scene of a level made of `statements`. Fails the test if they have an error.
inline Scene load(const std::string& statements) {
    LoadResult result = load_level("carom 1 \"A test\"\n" + statements, "test.level");
    for (const Diagnostic& diagnostic : result.diagnostics)
        MESSAGE(render(diagnostic));
    REQUIRE(result.scene.has_value());
    return *result.scene;
}

}  // namespace carom::test
