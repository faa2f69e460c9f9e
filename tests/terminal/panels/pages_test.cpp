#include "terminal/panels/pages.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace carom;

namespace {

const std::vector<HelpSection> sections = {
    {"Time", {{"space", "pause, go on"}, {".", "one tick forward"}, {",", "one tick back"}}},
    {"Play",
     {{"left button", "drag a ball or the end of an edge"},
      {"right button", "pull the cue: the ball goes the other way, faster the longer the pull"},
      {"Tab", "from ball to ball"}}}};

const std::vector<MenuEntry> levels = {
    {"balls", "Balls of all sizes", "carom", {"Drag a ball with the left button."}, false},
    {"galton",
     "Galton board, 12 rows",
     "carom",
     {"Balls fall through rows of pegs, and what piles up is a bell."},
     false},
    {"mine", "My own", "this folder", {}, false},
    {"broken", "3 errors", "this folder", {"line 3: no such kind"}, true}};

std::string help(int columns, int rows, int scroll = 0) {
    Canvas canvas(columns, rows);
    draw_help(canvas, sections, scroll, "Esc back", {0, false, false});
    return "\n" + canvas.text();
}

std::string menu(int columns, int rows, std::size_t selected = 1) {
    Canvas canvas(columns, rows);
    draw_menu(canvas, levels, selected, "Enter play", {0, false, false});
    return "\n" + canvas.text();
}

}  // namespace

TEST_CASE("a window below 20 x 8 is too small, and says so whatever its size") {
    CHECK_FALSE(is_too_small(20, 8));
    CHECK(is_too_small(19, 8));
    CHECK(is_too_small(20, 7));
    Canvas canvas(18, 5);
    draw_too_small(canvas);
    CHECK("\n" + canvas.text() == R"(

    too small
   18x5 < 20x8
  make it larger

)");
    for (const auto& [columns, rows] : {std::pair{0, 0}, {1, 1}, {5, 2}, {300, 1}}) {
        Canvas tiny(columns, rows);
        draw_too_small(tiny);
    }
}

TEST_CASE("help has two columns if there is room") {
    CHECK(help(80, 10) == R"(
 Time                                    Play
 space         pause, go on              left button   drag a ball or the end
 .             one tick forward                        of an edge
 ,             one tick back             right button  pull the cue: the ball
                                                       goes the other way,
                                                       faster the longer the
                                                       pull
                                         Tab           from ball to ball

 Esc back
)");
}

TEST_CASE("help in a narrow window is wrapped, and scrolls") {
    CHECK(help(30, 10) == R"(
 Time
 space         pause, go on
 .             one tick
               forward
 ,             one tick back

 Play
 left button   drag a ball or
               the end of an
 Esc back    down: more below
)");
    CHECK(help(30, 10, 5) == R"(

 Play
 left button   drag a ball or
               the end of an
               edge
 right button  pull the cue:
               the ball goes
               the other way,
               faster the
 Esc back      up, down: more
)");
    Canvas canvas(30, 10);
    const PageExtent extent = draw_help(canvas, sections, 1000, "", {});
    CHECK(extent.most > 0);
    CHECK(extent.scroll == extent.most);
    CHECK(draw_help(canvas, sections, -3, "", {}).scroll == 0);
    Canvas tall(30, 60);
    CHECK(draw_help(tall, sections, 0, "", {}).most == 0);
}

TEST_CASE("found 7: help does not wrap its lines where there is room for them") {
    Canvas canvas(160, 24);
    draw_help(canvas, sections, 0, "", {0, false, false});
    CHECK(canvas.text().find(
              "pull the cue: the ball goes the other way, faster the longer the pull") !=
          std::string::npos);
}

TEST_CASE("found 12: in a page about a level, keys stay beside their meanings") {
    Canvas canvas(40, 14);
    const std::vector<PageItem> items = {{"", "Balls of every size on a torus."},
                                         {"", ""},
                                         {"right-drag", "a cue: the longer the line, the faster"},
                                         {"c", "colour by speed"}};
    draw_about(canvas, "Balls", "Drag a ball.", items, 0, "Esc back", {0, false, false});
    CHECK("\n" + canvas.text() == R"(
 Balls

 Goal  Drag a ball.

 Balls of every size on a torus.

 right-drag  a cue: the longer the
             line, the faster
 c           colour by speed




 Esc back
)");
}

TEST_CASE("no key is lost, whatever the window") {
    for (const int columns : {20, 33, 40, 79, 80, 120, 200, 300}) {
        std::string all;
        for (int scroll = 0; scroll < 60; ++scroll)
            all += help(columns, 8, scroll);
        for (const char* key : {"space", "left button", "right button", "Tab"}) {
            CAPTURE(columns);
            CHECK(all.find(key) != std::string::npos);
        }
    }
}

TEST_CASE("a page of text is wrapped at blanks") {
    Canvas canvas(30, 8);
    const std::vector<std::string> lines = {"one", "a line that is too long for the window",
                                            "three"};
    const PageExtent extent = draw_text_page(canvas, "broken.level", lines, 0, "Esc back", {});
    CHECK(extent.most == 0);
    CHECK("\n" + canvas.text() == R"(
 broken.level

 one
 a line that is too long for
 the window
 three

 Esc back
)");
}

TEST_CASE("the menu lists levels by group, and describes the selected one") {
    CHECK(menu(80, 12) == R"(
 carom  pick a level

 carom                             Galton board, 12 rows
   balls   Balls of all sizes
 > galton  Galton board, 12 rows   Balls fall through rows of pegs, and what
                                   piles up is a bell.
 this folder
   mine    My own
   broken  3 errors


 Enter play
)");
    CHECK(menu(40, 20) == R"(
 carom  pick a level

 carom
   balls   Balls of all sizes
 > galton  Galton board, 12 rows

 this folder
   mine    My own
   broken  3 errors






 Galton board, 12 rows

 Balls fall through rows of pegs, and
 what piles up is a bell.
 Enter play
)");
}

TEST_CASE("a preview's paragraphs are rewrapped, its lists are not") {
    const std::vector<MenuEntry> entries = {
        {"a",
         "A",
         "",
         {"The first line of a paragraph, which is as long as an editor's window is",
          "wide, goes on.", "",
          "Try: + faster   - slower   h histogram   t trails   and one thing more", "x a list"},
         false}};
    Canvas canvas(120, 12);
    draw_menu(canvas, entries, 0, "", {0, false, false});
    CHECK("\n" + canvas.text() == R"(
 carom  pick a level

 > a  A                           A

                                  The first line of a paragraph, which is as long as an editor's window is wide, goes
                                  on.

                                  Try: + faster   - slower   h histogram   t trails   and one thing more
                                  x a list



)");
}

TEST_CASE("the selected entry is visible in any window, and the mouse finds it") {
    std::vector<MenuEntry> many;
    for (int i = 0; i < 60; ++i)
        many.push_back({"level" + std::to_string(i), "title", "carom", {}, false});
    for (const auto& window : {std::pair{20, 8}, {40, 20}, {80, 24}, {200, 60}}) {
        const int columns = window.first;
        const int rows = window.second;
        for (std::size_t selected = 0; selected < many.size(); ++selected) {
            Canvas canvas(columns, rows);
            draw_menu(canvas, many, selected, "", {});
            bool is_seen = false;
            for (int row = 0; row < rows; ++row) {
                if (menu_entry_at(columns, rows, many, selected, 2, row) != selected) continue;
                is_seen = true;
                CHECK(canvas.at(1, row).glyph == U'>');
                CHECK((canvas.at(1, row).attributes & reverse) != 0);
            }
            CAPTURE(selected);
            CAPTURE(columns);
            CHECK(is_seen);
        }
    }
}

TEST_CASE("outside its list the menu has no entries") {
    CHECK_FALSE(menu_entry_at(80, 12, levels, 0, 2, 0));
    CHECK_FALSE(menu_entry_at(80, 12, levels, 0, 2, 2));  // a heading
    CHECK(menu_entry_at(80, 12, levels, 0, 2, 3) == 0);
    CHECK_FALSE(menu_entry_at(80, 12, levels, 0, 79, 3));
    CHECK_FALSE(menu_entry_at(80, 12, levels, 0, 2, 11));
    CHECK_FALSE(menu_entry_at(80, 12, {}, 0, 2, 3));
}

TEST_CASE("only a large window has room for a picture of the level") {
    const CellArea area = menu_picture_area(120, 40, levels, 1);
    CHECK(area.rows > 20);
    CHECK(area.column + area.columns <= 120);
    CHECK(area.row + area.rows <= 39);
    CHECK(menu_picture_area(40, 20, levels, 1) == CellArea{});
    CHECK(menu_picture_area(120, 40, levels, 99) == CellArea{});
}

TEST_CASE("an empty menu, and a window without cells, can be drawn") {
    Canvas canvas(40, 10);
    draw_menu(canvas, {}, 0, "q quit", {});
    for (const auto& [columns, rows] : {std::pair{0, 0}, {1, 1}, {3, 2}, {80, 3}}) {
        Canvas tiny(columns, rows);
        draw_menu(tiny, levels, 3, "q quit", {});
        draw_help(tiny, sections, 0, "q quit", {});
        draw_text_page(tiny, "title", {}, 0, "q quit", {});
    }
}
