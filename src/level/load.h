#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "level/scene/load_options.h"
#include "level/scene/scene.h"
#include "level/text/diagnostic.h"

/// Text to level to world. The loader opens no files: whoever calls it says what an include means.
namespace carom {

struct LoadResult {
    std::optional<Scene> scene;           ///< none when there is an error
    std::vector<Diagnostic> diagnostics;  ///< in order of file and line; at most 20
};

/// Never crashes, hangs or throws, whatever the bytes.
LoadResult load_level(std::string_view text, std::string_view file,
                      const LoadOptions& options = {});

}  // namespace carom
