#include "level/support/files.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace carom::test {

std::string read_file(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::filesystem::path> level_files(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() == ".level") files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
}

LoadOptions options_for(const std::filesystem::path& folder) {
    LoadOptions options;
    options.resolve_include = [folder](std::string_view from,
                                       std::string_view path) -> std::optional<IncludedFile> {
        const std::filesystem::path name = std::filesystem::path(from).parent_path() / path;
        if (!std::filesystem::exists(folder / name)) return std::nullopt;
        return IncludedFile{name.generic_string(), read_file(folder / name)};
    };
    return options;
}

std::string rendered(const LoadResult& result) {
    std::string text;
    for (const Diagnostic& diagnostic : result.diagnostics)
        text += render(diagnostic);
    return text;
}

LoadResult load_lines(std::string_view lines, const LoadOptions& options) {
    return load_level("carom 1 \"Test\"\n" + std::string(lines), "test.level", options);
}

Scene load_clean(std::string_view lines, const LoadOptions& options) {
    LoadResult result = load_lines(lines, options);
    CHECK(rendered(result) == "");
    REQUIRE(result.scene);
    return std::move(*result.scene);
}

}  // namespace carom::test
