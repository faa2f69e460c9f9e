#include <doctest/doctest.h>
#include <signal.h>

#include <filesystem>
#include <string>
#include <vector>

#include "carom/support/process.h"
#include "support/terminal_program.h"

using carom::test::ProgramOptions;
using carom::test::TemporaryFolder;
using carom::test::TerminalProgram;

namespace {

ProgramOptions at(const TemporaryFolder& home) {
    ProgramOptions options;
    options.columns = 120;
    // The leak checker would trace the process from another one, which a guest may not start.
    options.environment = {{"HOME", home.path()}, {"ASAN_OPTIONS", "detect_leaks=0"}};
    return options;
}

std::vector<std::string> guest(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{CAROM_BINARY_DIR "/carom", "--guest", "anna"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

}  // namespace

TEST_CASE("a guest saves levels into its folder, and the oldest gives way") {
    const TemporaryFolder home;
    TerminalProgram program(guest({"--guest-saves", "1"}), at(home));
    REQUIRE(program.wait_for_text("enter play"));
    program.send("cradle\r");
    REQUIRE(program.wait_for_text("menu"));
    program.send("w\r");
    REQUIRE(program.wait_for_text("Saved as cradle-1.level"));
    usleep(1'100'000);
    program.send("w\r");
    CHECK(program.wait_for_text("cradle-1.level, the oldest of 1, is gone"));
    program.send("q");
    CHECK(program.exit_status() == 0);
    namespace fs = std::filesystem;
    const fs::path folder = home.path(".local/share/carom/guests/anna");
    int levels = 0;
    for (const auto& entry : fs::recursive_directory_iterator(home.path()))
        if (entry.is_regular_file()) {
            CAPTURE(entry.path().string());
            CHECK(entry.path().parent_path() == folder / "levels");
            ++levels;
        }
    CHECK(levels == 1);
}

TEST_CASE("a guest who presses no key is sent away, and the game is kept") {
    const TemporaryFolder home;
    {
        TerminalProgram program(guest({"--guest-idle", "3s"}), at(home));
        REQUIRE(program.wait_for_text("enter play"));
        program.send("cradle\r");
        REQUIRE(program.wait_for_text("menu"));
        CHECK(program.wait_for_text("ended after 3 s without a key", 20.0));
        CHECK(program.exit_status() == 0);
        CHECK(program.what_is_left_dirty() == "");
    }
    TerminalProgram program(guest({}), at(home));
    CHECK(program.wait_for_text("Unfinished"));
    program.send("q");
    CHECK(program.exit_status() == 0);
}
