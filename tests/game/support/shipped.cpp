#include "game/support/shipped.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include <doctest/doctest.h>

#include "level/load.h"

namespace carom::test {
namespace {

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

std::vector<std::string> pinball_tables() {
    const auto folder = std::filesystem::path(CAROM_SOURCE_DIR) / "levels";
    std::vector<std::string> names;
    for (const auto& file : std::filesystem::directory_iterator(folder))
        if (file.path().extension() == ".level" &&
            text_of(file.path()).find("\ngame pinball") != std::string::npos)
            names.push_back(file.path().stem().string());
    std::ranges::sort(names);
    return names;
}

Scene shipped_level(const std::string& name, std::vector<std::string> overrides) {
    const auto folder = std::filesystem::path(CAROM_SOURCE_DIR) / "levels";
    LoadOptions options;
    options.overrides = std::move(overrides);
    options.resolve_include = [folder](std::string_view, std::string_view path) {
        return std::optional(IncludedFile{std::string(path), text_of(folder / path)});
    };
    LoadResult result = load_level(text_of(folder / (name + ".level")), name + ".level", options);
    REQUIRE(result.scene);
    return std::move(*result.scene);
}

BallId named(const Scene& scene, std::string_view name) {
    for (std::size_t i = 0; i < scene.ball_names.size(); ++i)
        if (scene.ball_names[i] == name) return BallId{static_cast<std::uint32_t>(i)};
    FAIL("no such ball");
    return BallId{};
}

}  // namespace carom::test
