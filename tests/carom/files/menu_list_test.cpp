#include "carom/files/menu_list.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "carom/files/level_files.h"

using namespace carom;

TEST_CASE("a menu list names groups, levels and a line about each") {
    const auto levels =
        menu_list("# comment\nloose\n[Play]\n\n  gas   1,000 balls  \n[More\nnine-ball");
    REQUIRE(levels.size() == 3);
    CHECK(levels[0].group.empty());
    CHECK(levels[1].group == "Play");
    CHECK(levels[1].name == "gas");
    CHECK(levels[1].line == "1,000 balls");
    CHECK(levels[2].group == "More");
    CHECK(levels[2].line.empty());
    CHECK(menu_list("").empty());
}

TEST_CASE("each level in the menu list ships, once, with a line that fits at 80 columns") {
    const std::string folder = CAROM_SOURCE_DIR "/levels";
    const auto shipped = levels_in(folder);
    const auto listed = menu_list_in(folder);
    CHECK(listed.size() > 20);
    for (const ListedLevel& level : listed) {
        CAPTURE(level.name);
        CHECK(std::ranges::count(shipped, level.name, &LevelEntry::name) == 1);
        CHECK(std::ranges::count(listed, level.name, &ListedLevel::name) == 1);
        CHECK_FALSE(level.line.empty());
        CHECK(level.line.size() <= 38);
    }
}
