#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "level/build/all_statements.h"
#include "level/support/files.h"
#include "level/text/text.h"

using namespace carom;
using namespace carom::test;

namespace {

struct Example {
    std::string text;
    int line = 0;
};

std::string manual() {
    return read_file(std::filesystem::path(CAROM_SOURCE_DIR) / "docs/levels.md");
}

// The code blocks of the manual with the fence ```KIND.
std::vector<Example> examples(std::string_view kind) {
    const std::string text = manual();
    std::vector<Example> found;
    const std::string fence = "```" + std::string(kind);
    bool is_inside = false;
    int number = 0;
    for (const std::string_view line : split_lines(text)) {
        ++number;
        if (is_inside && line == "```") {
            is_inside = false;
        } else if (is_inside) {
            found.back().text += std::string(line) + "\n";
        } else if (line == fence) {
            is_inside = true;
            found.push_back({"", number});
        }
    }
    return found;
}

LoadOptions with_walls() {
    LoadOptions options;
    options.resolve_include = [](std::string_view, std::string_view path) {
        CHECK(path == "walls.level");
        return std::optional(IncludedFile{"walls.level", "box 0,0 100,60 r=1\n"});
    };
    return options;
}

}  // namespace

TEST_CASE("every example of the manual loads without a diagnostic") {
    const auto all = examples("carom");
    CHECK(all.size() > 15);
    for (const Example& example : all) {
        const bool is_whole = example.text.substr(0, 5) == "carom";
        const std::string text = (is_whole ? "" : "carom 1 \"Manual\"\n") + example.text;
        const LoadResult result = load_level(text, "docs/levels.md", with_walls());
        CAPTURE(example.line);
        CHECK(rendered(result) == "");
        CHECK(result.scene.has_value());
    }
}

TEST_CASE("the manual has an example of every statement, key and flag") {
    std::string all;
    for (const Example& example : examples("carom"))
        all += example.text;
    const std::string text = manual();
    for (const Statement& statement : all_statements().rows()) {
        CAPTURE(statement.name);
        CHECK(("\n" + all).find("\n" + std::string(statement.name)) != std::string::npos);
        for (const KeyRule& key : statement.keys) {
            CAPTURE(key.name);
            CHECK(text.find(std::string(key.name) + "=") != std::string::npos);
        }
        for (const std::string_view flag : statement.flags)
            CHECK(all.find(std::string(flag)) != std::string::npos);
    }
}

TEST_CASE("the syntax file for Vim knows every statement") {
    std::istringstream file(
        read_file(std::filesystem::path(CAROM_SOURCE_DIR) / "docs/editors/carom.vim"));
    std::vector<std::string> listed;
    for (std::string line; std::getline(file, line);) {
        const std::string start = "syntax keyword caromStatement ";
        if (!line.starts_with(start)) continue;
        std::istringstream words(line.substr(start.size()));
        for (std::string word; words >> word;)
            listed.push_back(word);
    }
    const auto known = all_statements().keywords();
    std::vector<std::string> wanted(known.begin(), known.end());
    std::ranges::sort(wanted);
    std::ranges::sort(listed);
    // `end` closes blocks, and is no statement of its own.
    std::erase(listed, "end");
    std::erase(wanted, "end");
    CHECK(listed == wanted);
}

TEST_CASE("the grammar of the manual equals that of the statement table") {
    const auto blocks = examples("grammar");
    REQUIRE(blocks.size() == 1);
    CHECK(blocks[0].text == all_statements().grammar());
}

// A reader who writes each step below the last one has the game that stands at the end.
TEST_CASE("the six steps of the manual add up to the whole game, and each of them loads") {
    const std::string text = manual();
    const std::size_t begin = text.find("### A game in six steps");
    const std::size_t end = text.find("This is the whole game", begin);
    REQUIRE(end != std::string::npos);
    const std::string chapter = text.substr(begin, end - begin);
    std::string game;
    int steps = 0;
    bool is_fenced = false;
    const auto check_step = [&] {
        if (steps == 0) return;
        CAPTURE(steps);
        CHECK(load_level(game, "first-game.level", {}).scene.has_value());
    };
    for (const std::string_view line : split_lines(chapter)) {
        if (line.starts_with("```")) is_fenced = line != "```";
        if (line.starts_with("**")) {
            check_step();
            ++steps;
        }
        if (line.starts_with("    ")) game += std::string(line.substr(4)) + "\n";
        if (is_fenced && !line.starts_with("```")) game += std::string(line) + "\n";
    }
    CHECK(steps == 6);
    const auto all = examples("carom");
    CHECK(std::ranges::count(all, game, &Example::text) == 1);
}
