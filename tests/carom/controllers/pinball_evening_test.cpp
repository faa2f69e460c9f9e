#include <doctest/doctest.h>

#include <string>

#include "carom/support/at_table.h"

// What people meet who play a few games in an evening, one after another or together.
using namespace carom;
using namespace carom::test;

namespace {

std::string changed(std::string text, const std::string& what, const std::string& by) {
    REQUIRE(text.find(what) != std::string::npos);
    return text.replace(text.find(what), what.size(), by);
}

}  // namespace

TEST_CASE(
    "the demo takes no ball of a game of several players, and one stray key does not end it") {
    const TableHome home;
    home.write("work.level", changed(short_game, "balls=1", "balls=2 players=2"));
    AtTable table(home);
    table.key(U'p');
    table.pass(1.0);
    table.key(key::enter);
    for (int i = 0; i < 100 && !table.sees("> player 2"); ++i)
        table.pass(0.1);
    REQUIRE(table.sees("> player 2"));
    CHECK(table.sees("player 1  700"));
    // Player 2 comes back with a drink.
    bool is_taken = false;
    for (int i = 0; i < 300; ++i) {
        table.pass(0.1);
        is_taken = is_taken || table.sees("DEMONSTRATION");
    }
    CHECK_FALSE(is_taken);
    table.key(U'd');
    CHECK(table.sees("Press d again to watch carom play: no high score then."));
    table.key(U'r');
    CHECK(table.sees("Press r again to end this game."));
    table.key(U'q');
    CHECK(table.program.is_kept());
}

TEST_CASE("a table that nobody has played shows scores of the house, and asks who beats one") {
    for (const bool is_beaten : {false, true}) {
        CAPTURE(is_beaten);
        const TableHome home;
        home.write("work.level",
                   changed(short_game, "save=0s",
                           is_beaten ? "save=0s replay=5000" : "save=0s replay=10000"));
        AtTable table(home);
        CHECK(table.sees(is_beaten ? "1  MAR          2,000" : "1  MAR          4,000"));
        CHECK(table.sees("to beat: " + std::string(is_beaten ? "500" : "1,000") + " by IDA"));
        table.pass(1.0);
        table.key(key::enter);
        table.pass(8.0);
        CHECK(table.sees("GAME OVER"));
        CHECK(table.sees("YOUR INITIALS") == is_beaten);
        if (!is_beaten) continue;
        for (const char32_t letter : U"abc")
            if (letter != 0) table.key(letter);
        table.key(key::enter);
        table.pass(0.1);
        CHECK(table.sees("2  REX          1,000"));
        CHECK(table.sees("3  ABC            700"));
        CHECK_FALSE(table.sees("IDA"));
    }
}

TEST_CASE("the light of the ball saver goes out two seconds before it ends") {
    const TableHome home;
    home.write("work.level", changed(short_game, "save=0s", "save=2.5s"));
    AtTable table(home, true);
    table.pass(1.0);
    table.key(key::enter);
    table.pass(1.0);
    table.key(key::enter, InputEvent::Action::release);
    table.pass(0.1);
    CHECK(table.sees("ball saver 1 s"));
    table.pass(0.5);
    CHECK_FALSE(table.sees("ball saver"));
    for (int i = 0; i < 200 && table.sees("ball 1 of 1") && !table.sees("BALL SAVED"); ++i)
        table.pass(0.02);
    CHECK(table.sees("BALL SAVED"));
}

TEST_CASE("the list of a game that is over has every ball, and the demo shows what it scored") {
    const TableHome home;
    home.write("work.level", changed(short_game, "balls=1", "balls=2"));
    AtTable table(home);
    for (int ball = 0; ball < 2; ++ball) {
        table.pass(1.0);
        table.key(key::enter);
        table.pass(5.0);
    }
    REQUIRE(table.sees("GAME OVER"));
    CHECK(table.sees("ball 1              700"));
    CHECK(table.sees("ball 2              700"));
    table.key(key::escape);
    bool is_shown = false;
    for (int i = 0; i < 300 && !is_shown; ++i) {
        table.pass(0.1);
        is_shown = table.sees("DEMONSTRATION") && table.sees("last game: 1,400");
    }
    CHECK(is_shown);
}

TEST_CASE("the score and the task can be read in a narrow window") {
    const TableHome home;
    home.write(
        "work.level",
        short_game + std::string("task \"SHOOT THE LANE AT THE LEFT, ONCE AGAIN\" for lane\n"));
    AtTable table(home);
    table.pass(1.0);
    table.key(key::enter);
    table.pass(2.5);
    for (const int columns : {30, 50}) {
        CAPTURE(columns);
        table.window = Canvas{columns, columns == 30 ? 12 : 24};
        table.look();
        CHECK(table.sees("700, ball 1 of 1"));
        CHECK(table.sees("SHOOT THE LANE AT"));
    }
}

TEST_CASE("no frame between two balls shows the goal of the level in place of the task") {
    const TableHome home;
    std::string text = changed(short_game, "balls=1", "balls=2");
    text = changed(text, "units mm", "# Goal: Cross the lane.\nunits mm");
    home.write("work.level", text + "task \"SHOOT THE LANE\" for lane\n");
    AtTable table(home);
    table.pass(1.0);
    table.key(key::enter);
    table.pass(1.0);
    REQUIRE(table.sees("SHOOT THE LANE"));
    // The line of the table is the first below it.
    const auto line = [&] {
        table.look();
        std::string cells;
        for (int column = 0; column < 100; ++column)
            cells += static_cast<char>(table.window.at(column, table_rows).glyph & 0x7fU);
        return cells;
    };
    bool sees_goal = false;
    for (int i = 0; i < 4000 && !table.sees("ball 2 of 2"); ++i) {
        table.pass(0.001);
        sees_goal = sees_goal || line().find("Cross the lane") != std::string::npos;
    }
    CHECK(table.sees("ball 2 of 2"));
    CHECK_FALSE(sees_goal);
}

TEST_CASE("no message hides how far the plunger is pulled") {
    const TableHome home;
    AtTable table(home);
    table.key(U'd');
    table.pass(0.1);
    table.key(U'z');
    REQUIRE(table.sees("your game"));
    table.key(key::enter);
    table.pass(0.3);
    CHECK(table.sees("plunger "));
    CHECK_FALSE(table.sees("your game"));
}
