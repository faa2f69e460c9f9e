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
              .starts_with("  #     ### ###\n"
                           " ##     # #   #\n"
                           "  #     # #   #\n"
                           "  #   # # #  #\n"
                           " ### #  ###  #\n"));
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

TEST_CASE("a high panel lists the lights and the balls of the game, a low one neither") {
    ScorePanel panel{.title = "T", .score = "1"};
    panel.lights = {{.name = "LOCK", .lamps = {true, true, false}},
                    {.name = "JACKPOT", .lamps = {false}}};
    panel.balls = {"ball 1            12,340"};
    panel.high_scores = {{"1", "ABC", "100", false}};
    const std::string high = drawn(panel, 34, 40, ascii);
    CHECK(high.find("##.  LOCK") != std::string::npos);
    CHECK(high.find(".    JACKPOT") != std::string::npos);
    CHECK(high.find("ball 1") > high.find("JACKPOT"));
    CHECK(high.find("ABC") > high.find("ball 1"));
    CHECK(drawn(panel, 34, 14, ascii).find("LOCK") == std::string::npos);
    // No list takes the room of the high scores, or shows a part of itself.
    for (int rows = 16; rows < 40; ++rows) {
        CAPTURE(rows);
        const std::string text = drawn(panel, 34, rows, ascii);
        CHECK(text.find("ABC") != std::string::npos);
        CHECK((text.find("LIGHTS") == std::string::npos) ==
              (text.find("JACKPOT") == std::string::npos));
    }
}

TEST_CASE("a large moment takes three rows, with spaces between its letters where there is room") {
    ScorePanel panel{.title = "T", .score = "5", .message = "JACKPOT", .lines = {"ball 1 of 3"}};
    const std::string small = drawn(panel, 34, 24, ascii);
    panel.moment = ScorePanel::Moment::large;
    panel.high_scores.push_back({"1", "ABC", "123,450", false});
    Canvas canvas(34, 24);
    draw_score_panel(canvas, {0, 0, 34, 24}, panel, ascii);
    int reversed = 0;
    for (int row = 0; row < 24; ++row)
        reversed += (canvas.at(1, row).attributes & reverse) != 0 ? 1 : 0;
    CHECK(small.find("JACKPOT") != std::string::npos);
    CHECK(canvas.text().find("J A C K P O T") < canvas.text().find("HIGH SCORES"));
    CHECK(reversed == 3);
    panel.message = "MULTIBALL: VAULT IS THE JACKPOT";
    CHECK(drawn(panel, 34, 24, ascii).find(panel.message) != std::string::npos);
    // A low panel has one row for it.
    CHECK(drawn(panel, 34, 12, ascii).find(panel.message) != std::string::npos);
}

TEST_CASE("a wide panel writes the score twice as large") {
    const std::string text = drawn({.score = "7"}, 72, 30, Look{256, true, false});
    CHECK(text.find("██████\n") != std::string::npos);
}

TEST_CASE("a rules card wraps the author's text, with each word above what it does") {
    Canvas canvas(30, 20);
    draw_rules_card(
        canvas, {0, 0, 30, 20}, "HOW TO PLAY",
        {"Goal: drop all targets.", "", "A table of", "two lines.", "",
         "  lanes     all three of them: the bonus", "            grows", "  z /       flippers"},
        ascii);
    const std::string text = canvas.text();
    CHECK_MESSAGE(
        text.find(" HOW TO PLAY\n\n Goal: drop all targets.\n\n A table of two lines.\n\n"
                  " lanes\n   all three of them: the\n   bonus grows\n z /\n   flippers\n") !=
            std::string::npos,
        text);
}

TEST_CASE("the pane behind a panel reaches all its edges") {
    const Look look{direct_colors, true, false};
    const auto has_pane = [](const Canvas& canvas) {
        for (int row = 1; row < canvas.rows() - 1; ++row)
            for (const int column : {1, canvas.columns() - 2})
                if (canvas.at(column, row).background == default_color) return false;
        return canvas.at(0, 1).background == default_color &&
               canvas.at(canvas.columns() - 1, 1).background == default_color;
    };
    Canvas panel(36, 26);
    draw_score_panel(panel, {1, 1, 34, 24}, {.title = "T", .score = "5"}, look);
    CHECK(has_pane(panel));
    Canvas card(36, 26);
    draw_rules_card(card, {1, 1, 34, 24}, "HOW TO PLAY", {"Goal: all of them."}, look);
    CHECK(has_pane(card));
}
