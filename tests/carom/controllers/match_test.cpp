#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "carom/support/home.h"

// A match of pool that is left unfinished and resumed another day.

using namespace carom;
using carom::test::Home;
using carom::test::Running;

namespace {

PlayOptions at_the_table(int opponent) {
    PlayOptions options;
    options.level = CAROM_SOURCE_DIR "/levels/nine-ball.level";
    options.overrides = {"game nineball race=3 clock=45s"};
    options.opponent = opponent;
    return options;
}

// Breaks, and waits until the balls are at rest.
void break_off(Running& running) {
    REQUIRE_FALSE(running.program.start());
    running.look();
    running.key(key::enter);  // the meter, and the stroke
    running.pass(0.3);
    running.key(key::enter);
    running.pass(0.1);
    for (int i = 0; i < 600 && running.sees("the balls roll"); ++i)
        running.pass(0.1);
    REQUIRE_FALSE(running.sees("the balls roll"));
}

// The status of the match: whose turn it is, and the time left.
std::string title_of(Running& running) {
    const std::string screen = running.look();
    const std::size_t at = screen.find("0:0 (race to 3), ");
    REQUIRE(at != std::string::npos);
    return screen.substr(at, std::min(screen.find("  ", at), screen.find('\n', at)) - at);
}

PlayOptions resuming() {
    PlayOptions options;
    options.resume = true;
    return options;
}

}  // namespace

TEST_CASE("a resumed match keeps score, turn, clock, aim and call") {
    const Home home;
    Running before(at_the_table(0));
    break_off(before);
    for (int i = 0; i < 7; ++i)
        before.key(key::left);
    before.key(key::up, shift);
    before.key(key::down);
    before.pass(2.0);
    const std::string title = title_of(before);
    CHECK(title.find("43 s") != std::string::npos);
    CHECK(before.sees("1.90 m/s"));
    CHECK(before.sees("follow 0.05"));
    before.look();
    before.key(U'q');
    CHECK(before.program.is_over());
    CHECK(before.program.is_kept());

    Running after(resuming());
    REQUIRE_FALSE(after.program.start());
    after.pass(0.1);
    CHECK(title_of(after) == title);
    CHECK(after.sees("1.90 m/s"));
    CHECK(after.sees("follow 0.05"));
    // In a match nothing is taken back.
    after.key(U'u');
    CHECK(after.sees("No shot can be undone"));
    CHECK(title_of(after) == title);
}

TEST_CASE("a match against carom resumes against an opponent of equal skill") {
    const Home home;
    {
        Running before(at_the_table(2));
        break_off(before);
        before.key(key::escape);
        CHECK(before.sees("Unfinished"));
        before.key(U'q');
    }
    Running after({});
    REQUIRE_FALSE(after.program.start());
    CHECK(after.sees("Unfinished"));
    after.key(key::enter);
    after.pass(0.1);
    CHECK_FALSE(after.sees("player 1"));
    CHECK((title_of(after).find("you") != std::string::npos ||
           title_of(after).find("carom") != std::string::npos));
    after.key(U'O');
    CHECK(after.sees("You play carom, 2 of 4, until the match is over"));
}

TEST_CASE("a table without a shot is not kept") {
    const Home home;
    Running running(at_the_table(0));
    REQUIRE_FALSE(running.program.start());
    running.pass(1.0);
    running.key(U'q');
    CHECK_FALSE(running.program.is_kept());
    Running nothing(resuming());
    CHECK(nothing.program.start());
}
