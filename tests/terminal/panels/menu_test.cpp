#include "terminal/panels/menu.h"

#include <doctest/doctest.h>

#include <string>
#include <utility>

using namespace carom;

namespace {

MenuPage page(std::size_t selected = 1) {
    return {.groups = {"Play", "Toys", "Yours"},
            .group = 1,
            .entries = {{"Balls", "Drag, shoot, collide", "", false},
                        {"Galton board", "300 balls make a bell", "", false},
                        {"Three Bumpers", "Pinball", "66,000", false},
                        {"broken", "", "", true}},
            .selected = selected,
            .goal = "Watch 300 balls pile up to a bell.",
            .notes = {" 1  ABC       66,000"},
            .footer = "enter play   q quit"};
}

std::string menu(int columns, int rows) {
    Canvas canvas(columns, rows);
    draw_menu(canvas, page(), {0, false, false});
    return "\n" + canvas.text();
}

}  // namespace

TEST_CASE("the menu: groups, one line a level, and words about the selected one") {
    CHECK(menu(80, 20) == R"(
 ooo c a r o m   pool, pinball and a physics laboratory
 Play   Toys   Yours
--------------------------------------------------------------------------------
   Balls
 > Galton board
   Three Bumpers             66,000
   broken






                                       300 balls make a bell
                                       Goal: Watch 300 balls pile up to a bell.
                                        1  ABC       66,000



 enter play   q quit
)");
    CHECK(menu(40, 20) == R"(
 ooo c a r o m
 Play   Toys   Yours
----------------------------------------
   Balls          Drag, shoot, collide
 > Galton board   300 balls make a bell
   Three Bumpers  Pinball        66,000
   broken








 300 balls make a bell
 Goal: Watch 300 balls pile up to a
 bell.
  1  ABC       66,000
 enter play   q quit
)");
}

TEST_CASE("a wide menu has the line about each level in its list") {
    CHECK(menu(140, 20).find("Balls          Drag, shoot, collide") != std::string::npos);
}

TEST_CASE("the selected entry is visible in any window, and the mouse finds it") {
    MenuPage many = page();
    many.entries.assign(60, {"level", "", "", false});
    for (const auto& size : {std::pair{20, 8}, {40, 20}, {80, 24}, {200, 60}}) {
        const int columns = size.first;
        const int rows = size.second;
        for (many.selected = 0; many.selected < many.entries.size(); ++many.selected) {
            Canvas canvas(columns, rows);
            draw_menu(canvas, many, {});
            bool is_seen = false;
            for (int row = 0; row < rows; ++row) {
                if (menu_entry_at(columns, rows, many, 2, row) != many.selected) continue;
                is_seen = true;
                CHECK(canvas.at(1, row).glyph == U'>');
                CHECK((canvas.at(1, row).attributes & reverse) != 0);
            }
            CAPTURE(columns);
            CHECK(is_seen);
        }
    }
}

TEST_CASE("outside its list the menu has no entries") {
    CHECK_FALSE(menu_entry_at(80, 12, page(), 2, 0));
    CHECK_FALSE(menu_entry_at(80, 12, page(), 2, 2));
    CHECK(menu_entry_at(80, 12, page(), 2, 3) == 0);
    CHECK_FALSE(menu_entry_at(80, 12, page(), 2, 7));
    CHECK_FALSE(menu_entry_at(80, 12, page(), 79, 3));
    CHECK_FALSE(menu_entry_at(80, 12, page(), 2, 11));
}

TEST_CASE("the mouse opens a group by its tab, and the open tab is always there") {
    CHECK(menu_group_at(80, page(), 1, 1) == 0);
    CHECK(menu_group_at(80, page(), 9, 1) == 1);
    CHECK_FALSE(menu_group_at(80, page(), 70, 1));
    CHECK_FALSE(menu_group_at(80, page(), 1, 2));
    MenuPage many = page();
    many.groups.assign(12, "Laboratory");
    for (many.group = 0; many.group < many.groups.size(); ++many.group) {
        bool is_seen = false;
        for (int column = 0; column < 20; ++column)
            is_seen = is_seen || menu_group_at(20, many, column, 1) == many.group;
        CAPTURE(many.group);
        CHECK(is_seen);
    }
}

TEST_CASE("at 80 columns all groups have a tab, also with unfinished games") {
    MenuPage all = page();
    all.groups = {"Unfinished",  "Play", "Challenge",  "Puzzles",
                  "Pool school", "Toys", "Laboratory", "Yours"};
    bool is_seen = false;
    for (int column = 0; column < 80; ++column)
        is_seen = is_seen || menu_group_at(80, all, column, 1) == 7;
    CHECK(is_seen);
    CHECK_FALSE(menu_group_at(80, all, 0, 1) == 7);
}

TEST_CASE("found 11: at 80x24 there is room for a picture of the level") {
    const CellArea area = menu_picture_area(80, 24, page());
    CHECK(area.rows >= 12);
    CHECK(area.columns >= 38);
    CHECK(area.column + area.columns <= 80);
    CHECK(menu_picture_area(40, 20, page()) == CellArea{});
    CHECK(menu_picture_area(120, 40, page(99)) == CellArea{});
}

TEST_CASE("in a large window words stand right below the picture, and say more about the level") {
    MenuPage wide = page();
    wide.picture_shape = 0.27;  // of a pool table
    wide.about = {{"", "Balls meet balls here."}, {"", ""}, {"t", "trails"}};
    for (const auto& size : {std::pair{80, 24}, {120, 40}, {200, 60}}) {
        const int columns = size.first;
        const int rows = size.second;
        CAPTURE(columns);
        const CellArea area = menu_picture_area(columns, rows, wide);
        CHECK(area.rows >= 0.27 * area.columns);
        CHECK(area.rows < 0.27 * area.columns + 1.0);
        Canvas canvas(columns, rows);
        draw_menu(canvas, wide, {0, false, false});
        const auto begins = [&](int row, std::string_view text) {
            const std::string all = canvas.text();
            std::size_t start = 0;
            for (int i = 0; i < row; ++i)
                start = all.find('\n', start) + 1;
            return all.substr(start + static_cast<std::size_t>(area.column), text.size()) == text;
        };
        const int below = area.row + area.rows + 1;
        CHECK(begins(below, "300 balls make a bell"));
        CHECK(begins(below + 4, "Balls meet balls here."));
        CHECK(begins(below + 6, "t  trails"));
    }
    wide.picture_shape = 2.0;  // of a pinball table
    CHECK(menu_picture_area(120, 40, wide) == menu_picture_area(120, 40, page()));
}

TEST_CASE("an empty menu, and a window without cells, can be drawn") {
    for (const auto& [columns, rows] : {std::pair{0, 0}, {1, 1}, {3, 2}, {80, 3}, {40, 10}}) {
        Canvas canvas(columns, rows);
        draw_menu(canvas, {}, {});
        draw_menu(canvas, page(), {});
        CHECK_FALSE(menu_entry_at(columns, rows, {}, 2, 3));
    }
}
