#include <doctest/doctest.h>
#include <signal.h>
#include <sys/wait.h>

#include <string>

#include "carom/support/process.h"
#include "support/terminal_program.h"

using carom::test::TemporaryFolder;
using carom::test::TerminalProgram;

TEST_CASE("a long run shows a bar on a terminal, and removes it") {
    const TemporaryFolder folder;
    const std::string level = folder.file("one.level", "carom 1 \"one\"\nball a at=0,0 v=1,0\n");
    TerminalProgram program({CAROM_BINARY_DIR "/carom", "run", level, "--time", "1e8", "--report",
                             folder.path("report")});
    REQUIRE(program.wait_for_text("of 12000000000, "));
    program.signal(SIGTERM);
    const auto status = program.wait_for_end();
    REQUIRE(status.has_value());
    CHECK(WIFSIGNALED(*status));
    CHECK(WTERMSIG(*status) == SIGTERM);
    CHECK(program.screen().text().find("tick") == std::string::npos);
    CHECK(folder.names() == std::vector<std::string>{"one.level", "report"});
}
