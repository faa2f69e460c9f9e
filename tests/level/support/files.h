#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "level/load.h"

/// Files for the tests of the loader, which itself opens none.
namespace carom::test {

/// The content of a file; empty if there is no such file.
std::string read_file(const std::filesystem::path& path);

/// The *.level files of a folder, sorted.
std::vector<std::filesystem::path> level_files(const std::filesystem::path& folder);

/// Options that resolve includes in `folder`, relative to the file that includes.
LoadOptions options_for(const std::filesystem::path& folder);

/// All diagnostics, rendered.
std::string rendered(const LoadResult& result);

/// Loads a level of these lines, below a first line `carom 1 "Test"`.
LoadResult load_lines(std::string_view lines, const LoadOptions& options = {});

/// Loads a level; the test fails if there is a diagnostic or no scene.
Scene load_clean(std::string_view lines, const LoadOptions& options = {});

}  // namespace carom::test
