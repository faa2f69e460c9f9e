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

TEST_CASE("the list of a game that is over has every ball") {
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
}
