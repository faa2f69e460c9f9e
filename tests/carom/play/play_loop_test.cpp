#include "carom/play/play_loop.h"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <signal.h>

#include <string>

#include "carom/support/at_home.h"
#include "carom/support/process.h"
#include "support/sanitizers.h"
#include "support/terminal_program.h"

using namespace carom::test;

namespace {

// Ticks of a few milliseconds: with two cores, they are computed in the second thread.
std::string heavy_level() {
    return fmt::format(
        "carom 1 \"Heavy ticks\"\n"
        "rate 60\n"
        "solver event\n"
        "kind light r=0.5\n"
        "box 0,0 440,240\n"
        "fill light count={} box=0,0,440,240 speed=400\n",
        has_sanitizers ? 1000 : 5000);
}

// The tick in the status line; -1 if it shows none.
int tick_of(const Emulator& screen) {
    const std::string text = screen.text();
    const std::size_t at = text.find("tick ");
    return at == std::string::npos ? -1 : std::stoi(text.substr(at + 5));
}

}  // namespace

TEST_CASE(
    "a heavy game handles keys, the mouse, new sizes and the end, whatever is being computed") {
    const TemporaryFolder folder;
    const std::string file = folder.path("game.replay");
    TerminalProgram game({CAROM_BINARY_DIR "/carom", "play",
                          folder.file("heavy.level", heavy_level()), "--record", file},
                         at_home(folder));
    REQUIRE(game.wait_for_text("Heavy ticks"));
    REQUIRE(game.wait_until([&] { return tick_of(game.screen()) > 20; }, 60.0));
    game.send("?");
    CHECK(game.wait_for_text("back to the game"));
    game.send("x");
    for (int i = 0; i < 20; ++i) {
        game.send(mouse_press(0, 40 + i, 10));
        game.send(mouse_drag(0, 41 + i, 11));
        game.send(mouse_release(0, 41 + i, 11));
        game.send(i % 2 == 0 ? "c" : "t");
        game.wait_until([] { return false; }, 0.02);  // it keeps drawing
    }
    // A key without an action, and a click on nothing, do not delay a tick.
    game.send("@" + mouse_press(1, 1, 1) + mouse_release(1, 1, 1));
    game.resize(100, 30);
    const int now = tick_of(game.screen());
    CHECK(game.wait_until([&] { return tick_of(game.screen()) > now + 10; }, 60.0));
    game.send("g");
    CHECK(game.wait_for_text("gravity"));
    SUBCASE("quit") {
        game.send("q");
    }
    SUBCASE("terminated") {
        game.signal(SIGTERM);
    }
    SUBCASE("hung up") {
        game.signal(SIGHUP);
    }
    SUBCASE("suspended first") {
        game.send("\x1a");
        const auto has_left = [&] {
            return game.output().find("\033[?1049l") != std::string::npos;
        };
        REQUIRE(game.wait_until([&] { return has_left() && game.screen().mode(1049); }));
        const int then = tick_of(game.screen());
        CHECK(game.wait_until([&] { return tick_of(game.screen()) > then + 5; }, 60.0));
        game.send("q");
    }
    const auto end = game.wait_for_end(60.0);
    REQUIRE(end);
    CHECK(*end == 0);
    CHECK(game.what_is_left_dirty().empty());
    // In either thread, commands come between the same ticks when it is replayed.
    CHECK(run_carom({"verify", file}).exit_code == 0);
}

TEST_CASE("a game starts and ends in a window of any size, whatever the environment says of it") {
    const TemporaryFolder folder;
    ProgramOptions options = at_home(folder);
    options.environment["COLUMNS"] = "99999999";
    options.environment["LINES"] = "99999999";
    SUBCASE("a size that only the environment gives") {
        options.columns = 0;
    }
    SUBCASE("a size that changes") {}
    TerminalProgram game({CAROM_BINARY_DIR "/carom", "play", "cradle"}, options);
    if (options.columns > 0) {
        REQUIRE(game.wait_for_text("tick"));
        game.claim_size(65535, 65535);
        game.claim_size(1, 1);
        game.resize(80, 24);
        REQUIRE(game.wait_for_text("tick"));
    } else {
        REQUIRE(game.wait_until([&] { return game.output().size() > 10'000; }, 30.0));
    }
    game.send("q");
    CHECK(game.wait_for_end(60.0) == 0);
    CHECK(game.what_is_left_dirty().empty());
}

TEST_CASE("the first picture fills a window that is larger than 80x24") {
    const TemporaryFolder folder;
    ProgramOptions options = at_home(folder);
    options.columns = 130;
    options.rows = 50;
    TerminalProgram game({CAROM_BINARY_DIR "/carom", "play", "cradle"}, options);
    REQUIRE(game.wait_for_text("tick"));
    game.wait_until([] { return false; }, 0.2);
    int rows_with_ticks = 0;
    for (int row = 0; row < 50; ++row)
        rows_with_ticks += game.screen().row(row).find("ticks/s") != std::string::npos ? 1 : 0;
    CHECK(rows_with_ticks == 1);
    bool is_at_the_bottom = false;
    for (int row = 46; row < 50; ++row)
        is_at_the_bottom |= game.screen().row(row).find("ticks/s") != std::string::npos;
    CHECK(is_at_the_bottom);
    game.send("q");
    CHECK(game.wait_for_end() == 0);
}

TEST_CASE("pasted text delays neither the end nor a hang-up") {
    const TemporaryFolder folder;
    TerminalProgram game(
        {CAROM_BINARY_DIR "/carom", "play", folder.file("heavy.level", heavy_level())},
        at_home(folder));
    REQUIRE(game.wait_for_text("Heavy ticks"));
    // Each of these keys steps one tick; all of them would take longer than this test may.
    game.send(" " + std::string(300'000, '.'));
    SUBCASE("terminated") {
        game.signal(SIGTERM);
    }
    SUBCASE("hung up") {
        game.signal(SIGHUP);
    }
    SUBCASE("Ctrl-C after it") {
        game.send("\x03");
    }
    const auto end = game.wait_for_end(10.0);
    REQUIRE(end);
    CHECK(game.what_is_left_dirty().empty());
}
