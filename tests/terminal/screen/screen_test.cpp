#include "terminal/screen/screen.h"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>

#include "support/terminal_program.h"

using carom::test::described;
using carom::test::mouse_drag;
using carom::test::mouse_press;
using carom::test::mouse_release;
using carom::test::ProgramOptions;
using carom::test::TerminalProgram;

namespace {

std::vector<std::string> probe(std::string_view words) {
    std::vector<std::string> arguments{CAROM_TERMINAL_PROBE};
    std::istringstream stream{std::string(words)};
    for (std::string word; stream >> word;) {
        arguments.push_back(word);
    }
    return arguments;
}

bool has_line(const std::string& log, std::string_view line) {
    return ("\n" + log).find(fmt::format("\n{}\n", line)) != std::string::npos;
}

std::size_t count_of(const std::string& text, std::string_view part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++count;
    }
    return count;
}

// A modern emulator with every feature.
ProgramOptions modern() {
    ProgramOptions options;
    options.emulator = {.has_key_protocol = true,
                        .has_pixel_mouse = true,
                        .has_synchronized_output = true,
                        .background = "rgb:ffff/ffff/eeee",
                        .cell_wide = 10,
                        .cell_high = 20};
    return options;
}

}  // namespace

TEST_CASE("a frame is one write, and 200 discs stay within the budget of bytes") {
    struct Row {
        std::string_view renderer;
        int most_bytes;  // per frame, 80x24
    };
    for (const Row& row : {Row{"ascii", 1250}, Row{"half", 1250}, Row{"braille", 2500}}) {
        TerminalProgram program(probe(fmt::format("{} frames 300", row.renderer)));
        REQUIRE(program.wait_for_log("frames", 60.0));
        int frames = 0;
        int writes = 0;
        int most = 0;
        int bytes = 0;
        REQUIRE(std::sscanf(program.log().c_str(), "frames %d writes %d most %d bytes %d", &frames,
                            &writes, &most, &bytes) == 4);
        MESSAGE("200 discs, 80x24, " << row.renderer << ": " << bytes << " bytes a frame");
        CHECK(writes == frames);
        CHECK(most == 1);
        CHECK(bytes > 100);  // else the discs do not move
        CHECK(bytes <= row.most_bytes);
        CHECK(program.exit_status() == 0);
        CHECK(program.what_is_left_dirty() == "");
    }
}

TEST_CASE("a program that waits for its frames ends when the terminal hangs up") {
    TerminalProgram program(probe("ascii frames 1000000"));
    REQUIRE(program.wait_until([&] { return program.output().size() > 10000; }));
    program.hang_up();
    const std::optional<int> status = program.wait_for_end();
    REQUIRE(status);
    CHECK((WIFEXITED(*status) && WEXITSTATUS(*status) == 7));
}

TEST_CASE("the terminal shows the canvas, cell by cell, after any changes") {
    TerminalProgram program(probe("random 400"));
    REQUIRE(program.wait_for_log("shown", 60.0));
    program.settle();
    std::istringstream log(program.log());
    int cells = 0;
    int wrong = 0;
    for (std::string line; std::getline(log, line);) {
        int column = 0;
        int row = 0;
        unsigned glyph = 0;
        int foreground = 0;
        int background = 0;
        int attributes = 0;
        if (std::sscanf(line.c_str(), "cell %d %d %x %d %d %d", &column, &row, &glyph, &foreground,
                        &background, &attributes) != 6) {
            continue;
        }
        ++cells;
        const std::string wanted = described({.glyph = static_cast<char32_t>(glyph),
                                              .foreground = foreground,
                                              .background = background,
                                              .is_bold = (attributes & carom::bold) != 0,
                                              .is_underlined = (attributes & carom::underline) != 0,
                                              .is_reversed = (attributes & carom::reverse) != 0});
        const std::string shown = described(program.screen().look(column, row));
        if (shown != wanted && ++wrong <= 5) {
            MESSAGE(column << ',' << row << " should be " << wanted << ", is " << shown);
        }
    }
    CHECK(cells == 80 * 24);
    CHECK(wrong == 0);
}

TEST_CASE("as many colours as the terminal has") {
    ProgramOptions options;
    SUBCASE("256") {
        TerminalProgram program(probe("cells"), options);
        REQUIRE(program.wait_for_log("shown"));
        program.settle();
        CHECK(program.screen().foreground(10, 3) == 202);
        CHECK(program.screen().background(10, 7) == 202);
        CHECK(program.screen().foreground(0, 9) == 1);
        CHECK(program.screen().background(0, 9) == 4);
        CHECK(program.screen().cell(1, 9).attrs.bold == 1);
        CHECK(program.screen().cell(2, 9).attrs.underline == 1);
        CHECK(program.screen().cell(3, 9).attrs.reverse == 1);
        CHECK(program.screen().cell(0, 9).chars[0] == 0x2580);
        CHECK(program.screen().cell(79, 23).chars[0] == '#');  // the last cell of the window
    }
    SUBCASE("16, as xterm-16color has") {
        options.environment["TERM"] = "xterm-16color";
        TerminalProgram program(probe("cells"), options);
        REQUIRE(program.wait_for_log("shown"));
        program.settle();
        CHECK(program.screen().foreground(12, 0) == 12);
        CHECK(program.screen().foreground(4, 3) == 9);  // 196, bright red
    }
    SUBCASE("8") {
        options.environment["TERM"] = "xterm";
        TerminalProgram program(probe("cells"), options);
        REQUIRE(program.wait_for_log("shown"));
        program.settle();
        CHECK(program.screen().foreground(4, 3) == 1);
        CHECK(program.screen().foreground(22, 0) == 2);  // 22, a dark green, is green, not black
    }
    SUBCASE("none, because the player wants none") {
        options.environment["NO_COLOR"] = "1";
        TerminalProgram program(probe("cells"), options);
        REQUIRE(program.wait_for_log("shown"));
        program.settle();
        CHECK(program.screen().foreground(4, 3) == std::nullopt);
        CHECK(program.screen().cell(15, 4).attrs.reverse == 1);  // white behind black text
        CHECK(program.output().find("\033[38;5;") == std::string::npos);
        CHECK(program.output().find("\033[31m") == std::string::npos);
    }
    SUBCASE("as many as the command line says, whatever NO_COLOR says") {
        options.environment["NO_COLOR"] = "1";
        TerminalProgram program(probe("colors=8 cells"), options);
        REQUIRE(program.wait_for_log("shown"));
        program.settle();
        CHECK(program.screen().foreground(4, 3) == 1);
    }
}

TEST_CASE("24-bit colours and octants, whatever TERM says") {
    constexpr int orange = 1 << 24 | 250 << 16 | 130 << 8 | 5;
    ProgramOptions options;
    const std::string asked = "colors=16777216 cells";
    std::string arguments = asked;
    SUBCASE("xterm-256color") {}
    SUBCASE("xterm-direct") {
        options.environment["TERM"] = "xterm-direct";
        arguments = "cells";
    }
    SUBCASE("screen-256color") {
        options.environment["TERM"] = "screen-256color";
    }
    SUBCASE("linux") {
        options.environment["TERM"] = "linux";
    }
    SUBCASE("vt100") {
        options.environment["TERM"] = "vt100";
    }
    SUBCASE("COLORTERM") {
        options.environment["COLORTERM"] = "truecolor";
        arguments = "cells";
    }
    TerminalProgram program(probe(arguments), options);
    REQUIRE(program.wait_for_log("shown"));
    program.settle();
    const carom::test::Emulator& screen = program.screen();
    CHECK(screen.foreground(4, 9) == orange);
    CHECK(screen.background(4, 9) == 4);
    // The octant on orange, or its complement in orange.
    const bool is_octant =
        screen.cell(5, 9).chars[0] == 0x1CD00 && screen.background(5, 9) == orange;
    const bool is_complement =
        screen.cell(5, 9).chars[0] == 0x1CDE3 && screen.foreground(5, 9) == orange;
    CHECK((is_octant || is_complement));
    CHECK(screen.cell(6, 9).chars[0] == 'x');  // an octant is one column wide
    CHECK(screen.foreground(10, 3) == 202);
    program.send("x");
    CHECK(program.exit_status() == 0);
    CHECK(program.what_is_left_dirty() == "");
}

TEST_CASE("24-bit colours become the nearest available ones") {
    ProgramOptions options;
    SUBCASE("256") {
        TerminalProgram program(probe("cells"), options);
        REQUIRE(program.wait_for_log("shown"));
        program.settle();
        CHECK(program.screen().foreground(4, 9) == 208);
        const std::uint32_t glyph = program.screen().cell(5, 9).chars[0];
        CHECK((glyph == 0x1CD00 || glyph == 0x1CDE3));  // or the complement, in exchanged colours
    }
    SUBCASE("8, though COLORTERM was inherited from elsewhere") {
        options.environment = {{"TERM", "linux"}, {"COLORTERM", "truecolor"}};
        TerminalProgram program(probe("cells"), options);
        REQUIRE(program.wait_for_log("shown"));
        program.settle();
        CHECK(program.screen().foreground(4, 9) == 1);
    }
}

TEST_CASE("a terminal without ECMA-48 gets the strings of its description") {
    ProgramOptions options;
    options.environment["TERM"] = "vt52";
    TerminalProgram program(probe("cells"), options);
    REQUIRE(program.wait_for_log("shown"));
    program.settle();
    CHECK(program.output().find("\033Y) \u2580bur") != std::string::npos);  // row 9, column 0
    CHECK(program.output().find("\033[10") == std::string::npos);
    program.send("x");
    CHECK(program.exit_status() == 0);
}

TEST_CASE("an old terminal without colour, in the C locale") {
    ProgramOptions options;
    options.environment = {{"TERM", "vt100"}, {"LC_ALL", "C"}};
    TerminalProgram program(probe("cells"), options);
    REQUIRE(program.wait_for_log("shown"));
    program.settle();
    CHECK(program.screen().foreground(4, 3) == std::nullopt);
    CHECK(program.screen().cell(0, 9).chars[0] == '?');
    CHECK(program.output().find("\033[?1049h") == std::string::npos);
    program.send("x");
    CHECK(program.exit_status() == 0);
    CHECK(program.what_is_left_dirty() == "");
}

TEST_CASE("the terminal's capabilities") {
    ProgramOptions options = modern();
    std::string wanted;
    SUBCASE("everything") {
        wanted =
            "size 80x24 colors 256 utf8 1 aspect 2.00 light 1 release 1 pixels 1 answers 1 ssh 0";
    }
    SUBCASE("a plain one that answers") {
        options.emulator = {};
        wanted =
            "size 80x24 colors 256 utf8 1 aspect 2.00 light 0 release 0 pixels 0 answers 1 ssh 0";
    }
    SUBCASE("one that never answers") {
        options.emulator.answers = false;
        wanted =
            "size 80x24 colors 256 utf8 1 aspect 2.00 light 0 release 0 pixels 0 answers 0 ssh 0";
    }
    SUBCASE("one that tells its size in pixels, through ssh") {
        options.emulator = {};
        options.pixels_wide = 80 * 9 + 5;
        options.pixels_high = 24 * 15;
        options.environment["SSH_CONNECTION"] = "::1 1 ::1 2";
        wanted =
            "size 80x24 colors 256 utf8 1 aspect 1.67 light 0 release 0 pixels 0 answers 1 ssh 1";
    }
    SUBCASE("a light one that says so in its environment") {
        options.emulator.answers = false;
        options.environment["COLORFGBG"] = "0;15";
        wanted =
            "size 80x24 colors 256 utf8 1 aspect 2.00 light 1 release 0 pixels 0 answers 0 ssh 0";
    }
    SUBCASE("a locale that is not installed says at least that it is UTF-8") {
        options.emulator.answers = false;
        options.environment["LC_ALL"] = "xx_XX.UTF-8";
        wanted =
            "size 80x24 colors 256 utf8 1 aspect 2.00 light 0 release 0 pixels 0 answers 0 ssh 0";
    }
    SUBCASE("TERM is not known") {
        options.environment["TERM"] = "no-such-terminal";
        wanted =
            "size 80x24 colors 256 utf8 1 aspect 2.00 light 1 release 1 pixels 1 answers 1 ssh 0";
    }
    SUBCASE("TERM is not set") {
        options.environment["TERM"] = "";
        wanted =
            "size 80x24 colors 256 utf8 1 aspect 2.00 light 1 release 1 pixels 1 answers 1 ssh 0";
    }
    SUBCASE("direct colours") {
        options.environment["TERM"] = "xterm-direct";
        wanted =
            "size 80x24 colors 256 utf8 1 aspect 2.00 light 1 release 1 pixels 1 answers 1 ssh 0";
    }
    SUBCASE("not asked, not wanted") {
        TerminalProgram program(probe("noqueries capabilities"), options);
        CHECK(program.exit_status() == 0);
        CHECK(program.output().find("\033[c") == std::string::npos);
        CHECK(program.log().find("answers 0") != std::string::npos);
        return;
    }
    TerminalProgram program(probe("capabilities"), options);
    CHECK(program.exit_status() == 0);
    CHECK(program.log() == wanted + "\n");
    CHECK(program.what_is_left_dirty() == "");
}

TEST_CASE("no terminal, or one that cannot position characters: the error has a remedy") {
    const std::string program = CAROM_TERMINAL_PROBE;
    SUBCASE("no input") {
        TerminalProgram run({"sh", "-c", program + " events </dev/null"});
        CHECK(run.exit_status() == 2);
        CHECK(run.log().find("standard input is not a terminal") != std::string::npos);
        CHECK(run.output() == "");
    }
    SUBCASE("no output") {
        TerminalProgram run({"sh", "-c", program + " events >/dev/null"});
        CHECK(run.exit_status() == 2);
        CHECK(run.log().find("standard output is not a terminal") != std::string::npos);
    }
    SUBCASE("dumb") {
        ProgramOptions options;
        options.environment["TERM"] = "dumb";
        TerminalProgram run({program, "events"}, options);
        CHECK(run.exit_status() == 2);
        CHECK(run.log().find("'dumb' cannot place characters") != std::string::npos);
        CHECK(run.what_is_left_dirty() == "");
    }
}

TEST_CASE("keys and the mouse arrive as sent") {
    TerminalProgram program(probe("events"));
    REQUIRE(program.wait_for_log("ready"));
    CHECK(program.screen().mode(1002));
    CHECK_FALSE(program.screen().mode(1003));
    CHECK(program.screen().mode(1006));
    // A press and its release in one read, beyond column 223.
    program.send(mouse_press(0, 300, 10) + mouse_release(0, 300, 10) + "x\033[1;2C\033OA\r");
    REQUIRE(program.wait_for_log("key d press"));
    CHECK(has_line(program.log(), "mouse press 1 300.50 10.50 0"));
    CHECK(has_line(program.log(), "mouse release 1 300.50 10.50 0"));
    CHECK(has_line(program.log(), "key x press 0"));
    CHECK(has_line(program.log(), "key 110003 press 1"));
    CHECK(has_line(program.log(), "key 110000 press 0"));
    program.send("\033");
    CHECK(program.wait_for_log("key 1b press 0"));
    program.send("b");
    CHECK(program.wait_until([&] { return program.screen().bells() == 1; }));
    program.send("q");
    CHECK(program.exit_status() == 7);
    CHECK(program.what_is_left_dirty() == "");
}

TEST_CASE("no report is lost in a burst of a thousand") {
    TerminalProgram program(probe("events"));
    REQUIRE(program.wait_for_log("ready"));
    std::string burst;
    for (int i = 0; i < 1000; ++i) {
        burst += mouse_drag(0, i % 80, i % 24);
    }
    program.send(burst);
    program.send("q");
    CHECK(program.exit_status() == 7);
    CHECK(count_of(program.log(), "mouse move 1 ") == 1000);
}

TEST_CASE("the mouse can be left to the terminal, and followed without a button") {
    TerminalProgram program(probe("events"), modern());
    REQUIRE(program.wait_for_log("ready"));
    CHECK(program.screen().mode(1016));
    program.send(mouse_press(0, 25, 30));  // pixels
    CHECK(program.wait_for_log("mouse press 1 2.55 1.52 0"));
    program.send("\033[109;1;109u");  // m
    CHECK(program.wait_until([&] { return !program.screen().mode(1002); }));
    CHECK_FALSE(program.screen().mode(1006));
    CHECK_FALSE(program.screen().mode(1016));
    program.send("\033[109;1:3u\033[109;1;109u");
    CHECK(program.wait_until([&] { return program.screen().mode(1003); }));
    program.send("\033[113;1;113u");
    CHECK(program.exit_status() == 7);
    CHECK(program.what_is_left_dirty() == "");
}

TEST_CASE("the release of a key, if the terminal reports it") {
    TerminalProgram program(probe("events"), modern());
    REQUIRE(program.wait_for_log("ready"));
    CHECK(program.screen().key_stack() == 1);
    program.send("\033[97;1;97u\033[97;1:2;97u\033[97;1:3u");
    REQUIRE(program.wait_for_log("release"));
    CHECK(has_line(program.log(), "key a press 0"));
    CHECK(has_line(program.log(), "key a repeat 0"));
    CHECK(has_line(program.log(), "key a release 0"));
    program.send("\033[99;5u");  // Ctrl-C
    CHECK(program.exit_status() == 7);
    CHECK(has_line(program.log(), "end"));
    CHECK(program.what_is_left_dirty() == "");
}

TEST_CASE("late answers are not keys") {
    ProgramOptions options;
    options.emulator.answers = false;
    TerminalProgram program(probe("events"), options);
    REQUIRE(program.wait_for_log("ready"));
    program.send("\033]11;rgb:ffff/ffff/ffff\033\\\033[?2026;2$y\033[?1016;0$y\033[?62;c\033[0n");
    program.send("x");
    REQUIRE(program.wait_for_log("key x"));
    CHECK(count_of(program.log(), "key") == 1);
    CHECK(has_line(program.log(), "resize"));  // the background is light, as the late answer says
    program.send("q");
    CHECK(program.exit_status() == 7);
    CHECK(program.what_is_left_dirty() == "");  // 2026 too
}

TEST_CASE("no answer reaches the shell") {
    TerminalProgram program({"bash", "-c", std::string(CAROM_TERMINAL_PROBE) + " events; cat"},
                            modern());
    REQUIRE(program.wait_for_log("ready"));
    program.send("xxxx\033[113;1;113u");
    CHECK(program.wait_for_log("key q"));
    program.settle(0.3);
    CHECK(program.screen().text().find("[") == std::string::npos);
    CHECK(program.what_is_left_dirty() == "");
}

TEST_CASE("the window can be resized at any moment, to far too small and back") {
    TerminalProgram program(probe("events"));
    REQUIRE(program.wait_for_text("probe 80x24"));
    for (const auto& [columns, rows] :
         {std::pair{100, 30}, {10, 3}, {1, 1}, {300, 100}, {80, 24}}) {
        program.resize(columns, rows);
        if (columns > 20) {
            CHECK(program.wait_for_text(fmt::format("probe {}x{}", columns, rows)));
            CHECK(program.wait_until([&, last = rows - 1] {
                return program.screen().row(last).starts_with("events ");
            }));
        } else {
            program.settle();
        }
    }
    CHECK(has_line(program.log(), "resize"));
    program.send("q");
    CHECK(program.exit_status() == 7);
    CHECK(program.what_is_left_dirty() == "");
}
