#include "terminal/panels/pool_panel.h"

#include <doctest/doctest.h>

#include <cstdlib>

using namespace carom;

TEST_CASE("pool panel: a strip where a table leaves rows free, a column where it leaves columns") {
    constexpr double shape = 1.8;
    CellArea tall{0, 0, 120, 37};
    CHECK(cut_pool_panel(tall, shape, 2.0) == CellArea{0, 0, 120, 3});
    CHECK(tall == CellArea{0, 3, 120, 34});
    CellArea wide{0, 0, 100, 21};
    CHECK(cut_pool_panel(wide, shape, 2.0).column == 95);
    CHECK(wide.columns == 95);
    CellArea narrow{0, 0, 79, 21};
    // Three free columns: the table gives up two more, for the tip.
    CHECK(cut_pool_panel(narrow, shape, 2.0).columns == 5);
    CHECK(narrow.columns == 74);
    CellArea small{0, 0, 40, 17};
    CHECK(cut_pool_panel(small, shape, 2.0) == CellArea{});
    CHECK(small == CellArea{0, 0, 40, 17});
}

TEST_CASE("pool panel: the score and the tray are over the middle of the table, tip or none") {
    PoolPanel panel;
    panel.players = {PoolPanel::Player{"Ann", "", {}, 2, true},
                     PoolPanel::Player{"carom", "", {}, 0, false}};
    panel.tray = {3, 10};
    for (const bool has_tip : {false, true}) {
        CAPTURE(has_tip);
        if (has_tip) panel.tip = PoolPanel::Tip{};
        Canvas canvas(101, 3);
        draw_pool_panel(canvas, {0, 0, 101, 3}, panel, ascii_renderer(), 2.0, {0, false, false});
        CHECK(canvas.at(50, 0).glyph == U':');
        int first = 0;
        while (canvas.at(first, 2).glyph == U' ')
            ++first;
        int last = 90;  // the tip is beyond
        while (canvas.at(last, 2).glyph == U' ')
            --last;
        CHECK(std::abs(first + last - 100) <= 1);
    }
}

TEST_CASE("pool panel: players, groups, the score and the tray, in ASCII without colours") {
    PoolPanel panel;
    panel.players = {PoolPanel::Player{"Ann", "solids", {1, 7}, 2, true},
                     PoolPanel::Player{"carom", "stripes", {9, 15}, 0, false}};
    panel.race = 5;
    panel.tray = {3, 10};
    panel.tip = PoolPanel::Tip{0.5, 0.0};
    Look look;
    look.colors = 0;
    look.utf8 = false;
    Canvas canvas(100, 3);
    draw_pool_panel(canvas, {0, 0, 100, 3}, panel, ascii_renderer(), 2.0, look);
    const std::string text = canvas.text();
    for (const char* part : {"> Ann", "solids  1  7", "2 : 0   race to 5", "carom", "stripes  9 15",
                             "pocketed  3 10", "x"})
        CHECK_MESSAGE(text.find(part) != std::string::npos, part, "\n", text);
    // The score is in the middle, and both players are beside it.
    CHECK(text.starts_with(std::string(30, ' ')));
    const std::size_t first = text.find("> Ann");
    CHECK(text.substr(first, 33) == "> Ann  2 : 0   race to 5    carom");
    Canvas column(3, 20);
    draw_pool_panel(column, {0, 0, 3, 20}, panel, ascii_renderer(), 2.0, look);
    CHECK(column.text().find(" 3\n 10\n") != std::string::npos);
}
