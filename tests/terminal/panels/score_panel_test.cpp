#include "terminal/panels/score_panel.h"

#include <doctest/doctest.h>

using namespace carom;

namespace {

std::string drawn(const ScorePanel& panel, int columns, int rows, const Look& look) {
    Canvas canvas(columns, rows);
    draw_score_panel(canvas, {0, 0, columns, rows}, panel, look);
    return canvas.text();
}

const Look ascii{0, false, false};

}  // namespace

TEST_CASE("a score is written in large digits") {
    CHECK(drawn({.score = "1,07"}, 34, 8, ascii)
              .starts_with("  #    ### ###\n"
                           " ##    # #   #\n"
                           "  #    # #   #\n"
                           "  #  # # #  #\n"
                           " ### # ###  #\n"));
    CHECK(drawn({.score = "7"}, 34, 8, Look{256, true, false}).starts_with(" ▀▀█\n  ▄▀\n  ▀\n"));
}

TEST_CASE("text that does not fit is small or left out, and nothing leaves the area") {
    const std::string text = drawn({.score = "123,456,789"}, 20, 6, ascii);
    CHECK(text.starts_with(" 123,456,789\n"));
    ScorePanel panel{
        .title = "T", .score = "1", .message = "A MESSAGE THAT IS TOO LONG", .lines = {"a", "b"}};
    panel.high_scores.push_back({"1", "ABC", "100", false});
    for (int rows = 0; rows < 24; ++rows) {
        Canvas canvas(30, 26);
        draw_score_panel(canvas, {5, 1, 20, rows}, panel, ascii);
        const std::string all = canvas.text();
        CHECK(canvas.at(4, 3).glyph == U' ');
        for (int row = rows + 1; row < 26; ++row)
            for (int column = 0; column < 30; ++column)
                CHECK(canvas.at(column, row).glyph == U' ');
    }
}

TEST_CASE("the table of scores comes last, with messages above it") {
    ScorePanel panel{
        .title = "Three Bumpers", .score = "5", .message = "JACKPOT", .lines = {"ball 1 of 3"}};
    panel.high_scores.push_back({"1", "ABC", "123,450", false});
    const std::string text = drawn(panel, 34, 24, ascii);
    CHECK(text.find("Three Bumpers") != std::string::npos);
    CHECK(text.find("JACKPOT") < text.find("HIGH SCORES"));
    CHECK(text.find(" 1  ABC        123,450") != std::string::npos);
}
