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

std::string help(int columns, int rows, int scroll = 0) {
    Canvas canvas(columns, rows);
    draw_help(canvas, sections, scroll, "Esc back", {0, false, false});
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

TEST_CASE("a heading is left out where nothing below it fits") {
    const std::vector<PageItem> items = {
        {"", "Balls."}, {"", ""}, {"", "Try:"}, {"c", "colour by speed"}};
    Canvas canvas(40, 4);
    draw_items(canvas, {0, 0, 40, 3}, items, {0, false, false});
    CHECK(canvas.text() == "Balls.\n\n\n\n");
    draw_items(canvas, {0, 0, 40, 4}, items, {0, false, false});
    CHECK(canvas.text() == "Balls.\n\nTry:\nc  colour by speed\n");
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

TEST_CASE("a window without cells can be drawn") {
    for (const auto& [columns, rows] : {std::pair{0, 0}, {1, 1}, {3, 2}, {80, 3}}) {
        Canvas tiny(columns, rows);
        draw_help(tiny, sections, 0, "q quit", {});
        draw_text_page(tiny, "title", {}, 0, "q quit", {});
    }
}
