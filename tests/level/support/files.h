#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "level/load.h"

/// Files for the tests of the loader, which itself opens none.
namespace carom::test {

/// Empty where there is no such file.
std::string read_file(const std::filesystem::path& path);

/// The *.level files of a folder, sorted.
std::vector<std::filesystem::path> level_files(const std::filesystem::path& folder);

/// Includes are looked for in `folder`, by the includer's own folder within it.
LoadOptions options_for(const std::filesystem::path& folder);

/// All messages as people read them, one after the other.
std::string rendered(const LoadResult& result);

/// A level of these lines, with the first line already there. Its messages, if any.
LoadResult load_lines(std::string_view lines, const LoadOptions& options = {});

/// Fails the test, with the messages, when there is no scene or any message.
Scene load_clean(std::string_view lines, const LoadOptions& options = {});

}  // namespace carom::test
