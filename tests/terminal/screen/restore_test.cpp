#include "terminal/screen/restore.h"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "support/terminal_program.h"

using carom::test::ProgramOptions;
using carom::test::TerminalProgram;

namespace {

const std::string probe = CAROM_TERMINAL_PROBE;

ProgramOptions modern() {
    ProgramOptions options;
    options.emulator = {.has_key_protocol = true,
                        .has_pixel_mouse = true,
                        .has_synchronized_output = true,
                        .cell_wide = 10,
                        .cell_high = 20};
    return options;
}

// The process that has the screen open.
pid_t player_of(const TerminalProgram& program) {
    const std::size_t at = program.log().find("ready ");
    return at == std::string::npos ? -1 : std::atoi(program.log().c_str() + at + 6);
}

}  // namespace

TEST_CASE("signals that request an exit are events, and the terminal is left clean") {
    struct Row {
        int signal;
        std::string_view event;
    };
    for (const bool is_supervised : {false, true}) {
        for (const Row& row : {Row{SIGINT, "end"}, Row{SIGQUIT, "end"}, Row{SIGTERM, "end"},
                               Row{SIGHUP, "hangup"}}) {
            CAPTURE(row.signal);
            CAPTURE(is_supervised);
            TerminalProgram program({probe, is_supervised ? "supervised" : "events", "events"},
                                    modern());
            REQUIRE(program.wait_for_log("ready"));
            program.signal(row.signal);
            CHECK(program.exit_status() == 7);
            CHECK(program.log().find(row.event) != std::string::npos);
            CHECK(program.what_is_left_dirty() == "");
        }
    }
}

TEST_CASE("no signal to the process group leaves the terminal dirty") {
    // As a shell, a job scheduler or `kill -- -PID` sends it: supervisor and player both receive
    // it.
    for (int signal = 1; signal < NSIG; ++signal) {
        const bool is_internal = signal > SIGSYS && signal < SIGRTMIN;  // used by the C library
        const bool cannot_be_caught = signal == SIGKILL || signal == SIGSTOP;
        const bool stops = signal == SIGTSTP || signal == SIGTTIN || signal == SIGTTOU;
        const bool is_harmless = signal == SIGCHLD || signal == SIGCONT || signal == SIGURG ||
                                 signal == SIGWINCH || signal == SIGPIPE || signal == SIGXFSZ;
        if (is_internal || cannot_be_caught || stops || is_harmless) continue;
        CAPTURE(signal);
        TerminalProgram program({probe, "supervised", "events"}, modern());
        REQUIRE(program.wait_for_log("ready"));
        kill(-program.process(), signal);
        CHECK(program.wait_for_end());
        CHECK(program.what_is_left_dirty() == "");
    }
}

TEST_CASE("Ctrl-C is an event too") {
    TerminalProgram program({probe, "supervised", "events"});
    REQUIRE(program.wait_for_log("ready"));
    program.send("\x03");
    CHECK(program.exit_status() == 7);
    CHECK(program.what_is_left_dirty() == "");
}

TEST_CASE("a crash leaves the terminal clean, supervised or not, and is reported") {
    for (const bool is_supervised : {false, true}) {
        for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGSYS}) {
            CAPTURE(signal);
            CAPTURE(is_supervised);
            ProgramOptions options = modern();
            options.environment["ASAN_OPTIONS"] =
                "handle_segv=0:handle_abort=0:handle_sigbus=0:handle_sigfpe=0:handle_sigill=0";
            TerminalProgram program(
                {probe, is_supervised ? "supervised" : "ascii", "crash", std::to_string(signal)},
                options);
            const auto status = program.wait_for_end();
            REQUIRE(status);
            CHECK(program.output().find("about to crash") != std::string::npos);
            CHECK(program.what_is_left_dirty() == "");
            const bool is_told = program.screen().text().find(fmt::format("signal {} ", signal)) !=
                                 std::string::npos;
            CHECK(is_told == is_supervised);
            CHECK(WIFSIGNALED(*status));
            CHECK(WTERMSIG(*status) == signal);
        }
    }
}

TEST_CASE("even after KILL the terminal is clean, and the player is told how to resume") {
    for (const bool has_answers : {true, false}) {
        ProgramOptions options = modern();
        options.emulator.answers = has_answers;
        TerminalProgram program({probe, "supervised", "events"}, options);
        REQUIRE(program.wait_for_log("ready"));
        CHECK(program.screen().mode(1049));
        kill(player_of(program), SIGKILL);
        const auto status = program.wait_for_end();
        REQUIRE(status);
        CHECK(WIFSIGNALED(*status));
        CHECK(WTERMSIG(*status) == SIGKILL);
        CHECK(program.what_is_left_dirty() == "");
        CHECK(program.screen().text().find("signal 9 (Killed)") != std::string::npos);
        CHECK(program.screen().text().find("Go on with: probe") != std::string::npos);
    }
}

TEST_CASE("a KILL of the supervisor makes the game exit cleanly") {
    TerminalProgram program({probe, "supervised", "events"}, modern());
    REQUIRE(program.wait_for_log("ready"));
    program.signal(SIGKILL);
    CHECK(program.wait_for_log("hangup"));
    program.settle(0.3);
    CHECK(program.what_is_left_dirty() == "");
}

TEST_CASE("a supervised program's exit status is returned") {
    TerminalProgram program({probe, "supervised", "capabilities"});
    CHECK(program.exit_status() == 0);
    CHECK(program.what_is_left_dirty() == "");
}

TEST_CASE("a terminal that vanishes is a hangup, and the program ends") {
    for (const bool is_supervised : {false, true}) {
        TerminalProgram program({probe, is_supervised ? "supervised" : "ascii", "events"});
        REQUIRE(program.wait_for_log("ready"));
        program.hang_up();
        CHECK(program.exit_status() == 7);
        CHECK(program.log().find("hangup") != std::string::npos);
    }
}

TEST_CASE("a stuck terminal does not block the exit") {
    TerminalProgram program({probe, "supervised", "random", "100000000"});
    REQUIRE(program.wait_until([&] { return program.output().size() > 10'000; }));
    CHECK_FALSE(program.wait_for_end_unread(0.5));
    program.signal(SIGTERM);
    CHECK(program.wait_for_end_unread(8.0));
    program.settle();
    CHECK(program.exit_status() == 7);
    CHECK(program.what_is_left_dirty() == "");
}

// Regression: a signal interrupts a write, but not one that begins after it. So a signal that came
// while a picture was drawn for a stuck terminal was not answered until the terminal read again.
TEST_CASE("a signal just before a write to a stuck terminal ends the program") {
    for (const std::string_view supervision : {"", "supervised"}) {
        std::vector<std::string> arguments{probe, "noqueries", "stuck"};
        if (!supervision.empty()) arguments.insert(arguments.begin() + 1, std::string(supervision));
        TerminalProgram program(arguments);
        const auto end = program.wait_for_end_unread(8.0);
        REQUIRE(end);
        CHECK(program.exit_status() == 7);
        program.settle();
        CHECK(program.what_is_left_dirty() == "");
    }
}

TEST_CASE("Ctrl-Z gives the terminal to the shell, and fg takes it back") {
    for (const std::string_view supervision : {"", "supervised"}) {
        for (const bool by_key : {true, false}) {
            CAPTURE(supervision);
            CAPTURE(by_key);
            const std::string script = fmt::format(
                "set -m; {} {} events; echo STOPPED $?; read line; fg >/dev/null; "
                "echo RETURNED $?",
                probe, supervision);
            TerminalProgram program({"bash", "-c", script});
            REQUIRE(program.wait_for_log("ready"));
            by_key ? program.send("\x1a") : (void)kill(player_of(program), SIGTSTP);
            REQUIRE(program.wait_for_text("STOPPED"));
            CHECK(program.what_is_left_dirty() == "");
            CHECK_FALSE(program.screen().mode(1049));
            program.send("\n");
            REQUIRE(program.wait_for_text("probe 80x24"));
            CHECK(program.screen().mode(1049));
            CHECK(program.wait_until([&] { return program.screen().mode(1002); }));
            CHECK(program.wait_for_log("resize"));
            program.send("q");
            CHECK(program.wait_for_text("RETURNED 7"));
            CHECK(program.what_is_left_dirty() == "");
        }
    }
}

TEST_CASE("without a shell to continue it, Ctrl-Z changes nothing") {
    TerminalProgram program({probe, "supervised", "events"});
    REQUIRE(program.wait_for_log("ready"));
    program.send("\x1a");
    CHECK(program.wait_for_log("resize"));
    program.send("q");
    CHECK(program.exit_status() == 7);
}

TEST_CASE("after STOP and CONT everything is drawn again") {
    TerminalProgram program({probe, "events"}, modern());
    REQUIRE(program.wait_for_log("ready"));
    program.signal(SIGSTOP);
    program.settle();
    program.signal(SIGCONT);
    CHECK(program.wait_for_log("resize"));
    program.settle();
    CHECK(program.screen().key_stack() == 1);
    CHECK(program.screen().text().find("probe 80x24") != std::string::npos);
    program.send("\033[113;1;113u");
    CHECK(program.exit_status() == 7);
    CHECK(program.what_is_left_dirty() == "");
}
