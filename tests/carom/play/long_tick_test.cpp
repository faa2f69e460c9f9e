#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "support/terminal_program.h"

using carom::test::TerminalProgram;
namespace fs = std::filesystem;

namespace {

// A tick is one second of a gas in which each ball spends its budget: many seconds of work.
std::string level(const std::string& solver) {
    const std::string head = "carom 1 \"Long ticks\"\nrate 1\nkind light r=0.5\n";
    if (solver == "event")
        return head + "solver event\nbox 0,0 560,300\n" +
               "fill light count=8000 box=0,0,560,300 speed=1000000\n";
    return head + "solver " + solver + "\nbox 0,0 313,168\n" +
           "fill light count=2500 box=0,0,313,168 speed=1000000\n";
}

// With sanitizers each step between two polls takes longer, s.
constexpr double patience = 30.0;

struct LevelFile {
    fs::path path =
        fs::temp_directory_path() / ("carom-long-" + std::to_string(::getpid()) + ".level");
    explicit LevelFile(const std::string& solver) { std::ofstream(path) << level(solver); }
    ~LevelFile() { fs::remove(path); }
};

}  // namespace

TEST_CASE("play answers keys inside a long tick") {
    std::string solver = "event";
    SUBCASE("event") {}
    SUBCASE("swept") {
        solver = "swept";
    }
    const LevelFile file(solver);
    const std::string folder = fs::temp_directory_path().string() + "/carom-long-home";
    TerminalProgram game(
        {CAROM_BINARY_DIR "/carom", "play", file.path.string()},
        {.environment = {{"XDG_CONFIG_HOME", folder}, {"XDG_STATE_HOME", folder}}});
    REQUIRE(game.wait_for_text("Long ticks", patience));
    game.send(".");
    game.settle();
    // The tick is under way; each of these cancels it, and is shown before the next tick starts.
    game.send("?");
    CHECK(game.wait_for_text("back to the game", patience));
    game.send("x");
    CHECK(game.wait_for_text("took too long", patience));
    game.send(" ");
    game.settle(0.5);
    game.send("G");
    CHECK(game.wait_for_text("gravity", patience));
    game.send("q");
    CHECK(game.wait_for_end(patience));
    fs::remove_all(folder);
}
