#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "level/scene/load_options.h"
#include "level/scene/scene.h"
#include "level/text/diagnostic.h"

/// Loads a level: text in, a scene or diagnostics out. README.md describes the stages. The loader
/// opens no files; the caller resolves includes (scene/load_options.h).
namespace carom {

struct LoadResult {
    std::optional<Scene> scene;           ///< absent when there is an error
    std::vector<Diagnostic> diagnostics;  ///< in order of file and line; at most 20
    std::uint64_t operations = 0;         ///< what loading has cost (text/load_budget.h)
};

/// Loads `text`, the content of the level `file`. The name is used in messages and as the base of
/// includes.
///
/// Never crashes, hangs or throws, whatever the bytes: sizes, nesting and work are bounded. The
/// largest levels, with a million balls, take about a second. The same text, includes and options
/// give the same scene, bit for bit.
LoadResult load_level(std::string_view text, std::string_view file,
                      const LoadOptions& options = {});

}  // namespace carom
