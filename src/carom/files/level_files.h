#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "level/load.h"

/// Where levels are, and what an `include` finds.
namespace carom {

/// The folder of the levels that ship: CAROM_LEVELS where it is set, else the one installed beside
/// the binary, else the source tree's. None: there is no such folder.
std::optional<std::string> shipped_levels_folder();

/// A level that can be chosen by name.
struct LevelEntry {
    std::string name;  ///< the file's, without the folder and `.level`
    std::string path;
    std::string title;  ///< of its first line; empty when it has none
};

/// The levels of a folder, by name. Files that cannot be read are left out.
std::vector<LevelEntry> levels_in(const std::string& folder);

/// A level as the user names it: the path of a file, or the name of a level that ships (a file
/// wins). None: there is neither, and `error` says so, with the nearest name if one is near.
struct FoundLevel {
    std::optional<std::string> path;
    std::string error;
};
FoundLevel find_level(const std::string& argument);

/// Resolves an include relative to the file that includes, inside its folder, then among the levels
/// that ship. Symbolic links that lead out of the folder are not followed.
IncludeResolver include_resolver();

/// Finds, reads and loads. Not found or not readable: no scene, no diagnostics, and `error` is set.
struct LoadedLevel {
    std::string path;
    std::string error;
    LoadResult result;
};
/// `options.resolve_include` is filled in.
LoadedLevel load_level_file(const std::string& argument, LoadOptions options);

}  // namespace carom
