#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/tick/solver_settings.h"

namespace carom {

/// A file that an `include` found.
struct IncludedFile {
    std::string file;  ///< its name for messages, and the base for its own includes
    std::string text;
};

/// Finds the file `path`, as written in the level `from`. The loader has already refused absolute
/// paths and paths that lead upward. None: there is no such file.
using IncludeResolver =
    std::function<std::optional<IncludedFile>(std::string_view from, std::string_view path)>;

/// Settings from the caller of the loader. The seed, the rate and the solver take precedence over
/// those of the level.
struct LoadOptions {
    IncludeResolver resolve_include;     ///< absent: every include is an error
    std::vector<std::string> overrides;  ///< statements that replace the file's, from --set
    std::optional<std::uint64_t> seed;
    std::optional<double> rate;  ///< ticks a second
    std::optional<SolverSettings> solver;
};

}  // namespace carom
