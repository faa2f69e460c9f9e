#include "carom/files/level_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "carom/files/files.h"
#include "carom/text/suggest.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view extension = ".level";

bool is_folder(const fs::path& path) {
    std::error_code error;
    return fs::is_directory(path, error);
}

bool is_file(const fs::path& path) {
    std::error_code error;
    return fs::exists(path, error) && !fs::is_directory(path, error);
}

// The title between the quotes of `carom 1 "title"`.
std::string title_of(const std::string& path) {
    const FileText head = read_file(path, 4096);
    if (!head.text) return {};
    const std::string_view line = std::string_view(*head.text).substr(0, head.text->find('\n'));
    const std::size_t open = line.find('"');
    const std::size_t close = open == line.npos ? line.npos : line.find('"', open + 1);
    if (!line.starts_with("carom ") || close == line.npos) return {};
    return std::string(line.substr(open + 1, close - open - 1));
}

// Whether `path` stays inside `folder` after all symbolic links are resolved.
bool is_inside(const fs::path& folder, const fs::path& path) {
    std::error_code error;
    const fs::path root = fs::weakly_canonical(folder.empty() ? "." : folder, error);
    const fs::path target = fs::weakly_canonical(path, error);
    if (error) return false;
    return std::mismatch(root.begin(), root.end(), target.begin(), target.end()).first ==
           root.end();
}

std::optional<IncludedFile> read_inside(const fs::path& folder, std::string_view path) {
    const fs::path file = folder / path;
    if (!is_file(file) || !is_inside(folder, file)) return std::nullopt;
    FileText content = read_file(file.string());
    if (!content.text) return std::nullopt;
    return IncludedFile{.file = file.string(), .text = std::move(*content.text)};
}

}  // namespace

std::optional<std::string> shipped_levels_folder() {
    if (const char* named = std::getenv("CAROM_LEVELS"); named != nullptr && *named != '\0') {
        return is_folder(named) ? std::optional<std::string>(named) : std::nullopt;
    }
    std::error_code error;
    const fs::path binary = fs::read_symlink("/proc/self/exe", error);
    if (!error) {
        const fs::path installed =
            (binary.parent_path() / CAROM_LEVELS_FROM_BINARY).lexically_normal();
        if (is_folder(installed)) return installed.string();
    }
    if (is_folder(CAROM_SOURCE_LEVELS)) return CAROM_SOURCE_LEVELS;
    return std::nullopt;
}

std::vector<LevelEntry> levels_in(const std::string& folder) {
    std::vector<LevelEntry> levels;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const fs::path& path = entry->path();
        if (path.extension() != extension || !is_file(path)) continue;
        levels.push_back({.name = path.stem().string(),
                          .path = path.string(),
                          .title = title_of(path.string())});
    }
    std::ranges::sort(levels, {}, &LevelEntry::name);
    return levels;
}

FoundLevel find_level(const std::string& argument) {
    if (is_file(argument)) return {.path = argument, .error = {}};
    if (is_folder(argument)) {
        return {.path = std::nullopt,
                .error = fmt::format("'{}' is a folder, not a level", argument)};
    }
    if (argument == "-") {
        return {.path = std::nullopt,
                .error = "a level on standard input is only for carom check: save it to a file"};
    }
    std::error_code error;
    if (fs::is_symlink(argument, error)) {
        return {.path = std::nullopt,
                .error = fmt::format("'{}' is a link that leads to no file", argument)};
    }
    const std::optional<std::string> folder = shipped_levels_folder();
    if (!folder) {
        return {.path = std::nullopt,
                .error = fmt::format("there is no level '{}': no such file, and there is no folder "
                                     "of levels that ship: set CAROM_LEVELS to it",
                                     argument)};
    }
    const std::vector<LevelEntry> shipped = levels_in(*folder);
    std::vector<std::string_view> names;
    for (const LevelEntry& level : shipped) {
        if (argument == level.name || argument == level.name + std::string(extension)) {
            return {.path = level.path, .error = {}};
        }
        names.push_back(level.name);
    }
    return {.path = std::nullopt,
            .error = fmt::format("there is no level '{}': no such file, and none of that name "
                                 "ships with carom (see `carom list`){}",
                                 argument, suggestion(argument, names))};
}

IncludeResolver include_resolver() {
    return [](std::string_view from, std::string_view path) -> std::optional<IncludedFile> {
        if (auto found = read_inside(fs::path(from).parent_path(), path)) return found;
        const std::optional<std::string> shipped = shipped_levels_folder();
        return shipped ? read_inside(*shipped, path) : std::nullopt;
    };
}

LoadedLevel load_level_file(const std::string& argument, LoadOptions options) {
    LoadedLevel loaded;
    FoundLevel found = find_level(argument);
    if (!found.path) {
        loaded.error = std::move(found.error);
        return loaded;
    }
    loaded.path = std::move(*found.path);
    FileText content = read_file(loaded.path);
    if (!content.text) {
        loaded.error = std::move(content.error);
        return loaded;
    }
    options.resolve_include = include_resolver();
    loaded.result = load_level(*content.text, loaded.path, options);
    return loaded;
}

}  // namespace carom
