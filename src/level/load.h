#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "level/diagnostic.h"
#include "level/scene.h"

/// Text to level to world. The loader opens no files: whoever calls it says what an include means.
namespace carom {

/// A file that an `include` found.
struct IncludedFile {
    std::string file;  ///< its name for messages, and the base for its own includes
    std::string text;
};

/// Finds `path`, as written in the level `from`. The loader has already refused absolute and upward
/// paths. None: there is no such file.
using IncludeResolver =
    std::function<std::optional<IncludedFile>(std::string_view from, std::string_view path)>;

struct LoadOptions {
    IncludeResolver resolve_include;     ///< absent: every include is an error
    std::vector<std::string> overrides;  ///< statements that replace the file's, from --set
    std::optional<std::uint64_t> seed;
    std::optional<double> rate;  ///< ticks a second
    std::optional<SolverSettings> solver;
};

struct LoadResult {
    std::optional<Scene> scene;           ///< none when there is an error
    std::vector<Diagnostic> diagnostics;  ///< in order of file and line; at most 20
};

/// Never crashes, hangs or throws, whatever the bytes.
LoadResult load_level(std::string_view text, std::string_view file,
                      const LoadOptions& options = {});

}  // namespace carom
