#include <doctest/doctest.h>
#include <signal.h>

#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <utility>

#include "support/ssh_server.h"
#include "support/terminal_program.h"

using carom::test::mouse_drag;
using carom::test::mouse_press;
using carom::test::mouse_release;
using carom::test::ProgramOptions;
using carom::test::SshServer;
using carom::test::TerminalProgram;

namespace {

constexpr int status_rows = 3;

struct Place {
    double column = 0.0;
    double row = 0.0;
};

// The centre of everything drawn above the status lines; none: nothing is.
std::optional<Place> ball_on(const carom::test::Emulator& screen) {
    Place sum;
    int cells = 0;
    for (int row = 0; row < screen.rows() - status_rows; ++row) {
        for (int column = 0; column < screen.columns(); ++column) {
            const auto glyph = screen.cell(column, row).chars[0];
            if (glyph == 0 || glyph == ' ') continue;
            sum.column += column;
            sum.row += row;
            ++cells;
        }
    }
    if (cells == 0) return std::nullopt;
    return Place{sum.column / cells, sum.row / cells};
}

bool is_at(const carom::test::Emulator& screen, double column, double row) {
    const auto ball = ball_on(screen);
    return ball && std::abs(ball->column - column) < 1.0 && std::abs(ball->row - row) < 1.0;
}

std::string played(const SshServer& server) {
    const std::string level = server.folder() + "/one.level";
    std::ofstream(level) << "carom 1 \"One ball\"\nworld 0,0 80,40\nrate 60\nball at=20,20 r=3\n";
    return "env XDG_CONFIG_HOME=" + server.folder() + " XDG_STATE_HOME=" + server.folder() + ' ' +
           CAROM_BINARY_DIR + "/carom play --paused " + level;
}

}  // namespace

TEST_CASE("played through a real sshd: a ball is dragged, and time is stepped") {
    const auto server = SshServer::start();
    if (!server) {
        MESSAGE("skipped: sshd is not installed (on Debian: openssh-server)");
        return;
    }
    ProgramOptions options;
    options.environment["LC_ALL"] = "C";
    TerminalProgram program(server->client(played(*server)), options);
    const bool has_started = program.wait_for_text("One ball", 30.0);
    INFO(server->log());
    INFO(program.screen().text());
    REQUIRE(has_started);
    REQUIRE(program.wait_until([&] { return ball_on(program.screen()).has_value(); }));
    const Place before = *ball_on(program.screen());
    CHECK(std::abs(before.column - 20.0) < 1.0);

    const int column = static_cast<int>(std::lround(before.column));
    const int row = static_cast<int>(std::lround(before.row));
    program.send(mouse_press(0, column, row));
    for (int i = 1; i <= 30; ++i) {
        program.send(mouse_drag(0, column + i, row - i / 6));
    }
    program.send("...");  // each dot is a single step; nothing else moves the world
    program.send(mouse_release(0, column + 30, row - 5));
    CHECK(program.wait_for_text("0.050 s"));
    CHECK(program.wait_until(
        [&] { return is_at(program.screen(), before.column + 30.0, before.row - 5.0); }));
    program.send(".");
    CHECK(program.wait_for_text("0.067 s"));
    program.settle();
    CHECK(is_at(program.screen(), before.column + 30.0, before.row - 5.0));

    program.send("q");
    CHECK(program.exit_status() == 0);
    CHECK(program.what_is_left_dirty() == "");
}

TEST_CASE("the window is resized through ssh") {
    const auto server = SshServer::start();
    if (!server) {
        MESSAGE("skipped: sshd is not installed (on Debian: openssh-server)");
        return;
    }
    ProgramOptions options;
    options.environment["LC_ALL"] = "C";
    TerminalProgram program(server->client(played(*server)), options);
    REQUIRE(program.wait_for_text("One ball", 30.0));
    program.resize(100, 40);
    CHECK(program.wait_until(
        [&] { return program.screen().row(37).find("One ball") != std::string::npos; }));
    program.resize(15, 5);
    program.settle(0.2);
    program.resize(80, 24);
    CHECK(program.wait_until(
        [&] { return program.screen().row(21).find("One ball") != std::string::npos; }));
    CHECK(program.wait_until([&] {
        const auto ball = ball_on(program.screen());
        return ball && std::abs(ball->column - 20.0) < 1.0;
    }));
    program.send("q");
    CHECK(program.exit_status() == 0);
    CHECK(program.what_is_left_dirty() == "");
}

TEST_CASE("a lost connection ends the game, which can be resumed") {
    const auto server = SshServer::start();
    if (!server) {
        MESSAGE("skipped: sshd is not installed (on Debian: openssh-server)");
        return;
    }
    ProgramOptions options;
    options.environment["LC_ALL"] = "C";
    const std::string command = played(*server);
    {
        TerminalProgram program(server->client(command), options);
        REQUIRE(program.wait_for_text("One ball", 30.0));
        program.send(".......");
        REQUIRE(program.wait_for_text("0.117 s"));
        program.signal(SIGKILL);
        program.wait_for_end();
    }
    const std::string again = command.substr(0, command.find(" play ")) + " play --resume";
    bool is_taken_up = false;
    for (int i = 0; i < 50 && !is_taken_up; ++i) {  // the first game takes some time to end
        TerminalProgram program(server->client(again), options);
        // However slow the machine: a game that is quit is not resumed again.
        is_taken_up = program.wait_until(
            [&] {
                const std::string shown = program.screen().text();
                return shown.find("0.117 s") != std::string::npos ||
                       shown.find("no unfinished game") != std::string::npos;
            },
            30.0);
        is_taken_up = is_taken_up && program.screen().text().find("0.117 s") != std::string::npos;
        program.send("q");
        program.wait_for_end();
    }
    CHECK(is_taken_up);
}
