#include <doctest/doctest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "support/terminal_program.h"

using carom::test::mouse_press;
using carom::test::mouse_release;
using carom::test::ProgramOptions;
using carom::test::TerminalProgram;

TEST_CASE("inside tmux") {
    if (std::system("command -v tmux >/dev/null 2>&1") != 0) {
        MESSAGE("skipped: tmux is not installed");
        return;
    }
    std::string folder = std::filesystem::temp_directory_path() / "carom-tmux-XXXXXX";
    REQUIRE(mkdtemp(folder.data()) != nullptr);
    const std::string log = folder + "/log";
    const std::string tmux = "tmux -u -f /dev/null -S " + folder + "/socket ";
    std::ofstream(folder + "/inside")
        << CAROM_TERMINAL_PROBE << " events 3>" << log << "\necho LEFT $?\nsleep 60\n";
    {
        // With its mouse on, tmux passes reports on to programs that ask for them.
        TerminalProgram program(
            {"sh", "-c", tmux + "new-session 'sh " + folder + "/inside' \\; set -g mouse on"});
        REQUIRE(program.wait_for_text("probe 80x23"));
        program.send(mouse_press(0, 30, 10) + mouse_release(0, 30, 10) + "x");
        REQUIRE(program.wait_for_text("events 3"));
        program.resize(100, 40);
        CHECK(program.wait_for_text("probe 100x39"));
        program.send("q");
        CHECK(program.wait_for_text("LEFT 7"));
        CHECK(program.screen().text().find("probe") == std::string::npos);
        std::system((tmux + "kill-server >/dev/null 2>&1").c_str());
        program.wait_for_end();
    }
    std::ostringstream text;
    text << std::ifstream(log).rdbuf();
    const std::string events = text.str();
    CHECK(events.find(
              "mouse press 1 30.50 10.50 0\nmouse release 1 30.50 10.50 0\nkey x press 0\n") !=
          std::string::npos);
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
}
