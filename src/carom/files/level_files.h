#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "level/load.h"

/// Finds levels and resolves includes.
namespace carom {

/// The folder of the levels that ship: CAROM_LEVELS if set, else the one installed beside the
/// binary, else the source tree's. None: there is no such folder.
std::optional<std::string> shipped_levels_folder();

/// A level that can be chosen by name.
struct LevelEntry {
    std::string name;  ///< the file name without folder and `.level`
    std::string path;
    std::string title;  ///< from its first line; empty if it has none
};

/// The levels of a folder, by name. Unreadable files are left out.
std::vector<LevelEntry> levels_in(const std::string& folder);

/// Finds a level as the user names it: the path of a file, or the name of a level that ships (a
/// file takes precedence). None: there is neither; `error` says so and suggests a similar name.
struct FoundLevel {
    std::optional<std::string> path;
    std::string error;
};
FoundLevel find_level(const std::string& argument);

/// Resolves an include relative to the including file, within its folder, then among the levels
/// that ship. Symbolic links that lead out of the folder are not followed.
IncludeResolver include_resolver();

/// Finds, reads and loads a level. If it cannot be found or read, there is no scene, no
/// diagnostics, and `error` is set.
struct LoadedLevel {
    std::string path;
    std::string error;
    LoadResult result;
};
/// Fills in `options.resolve_include`.
LoadedLevel load_level_file(const std::string& argument, LoadOptions options);

}  // namespace carom
