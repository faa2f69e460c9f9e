#include "carom/play/asciinema.h"

#include <doctest/doctest.h>
#include <signal.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "carom/support/at_home.h"
#include "carom/support/process.h"
#include "support/terminal_program.h"

using namespace carom;
using namespace carom::test;

namespace {

const char* const level =
    "carom 1 \"Zwei Bälle\"\n"
    "edge r=1  0,0  40,0  40,30  0,30  close\n"
    "ball a at=10,10 v=7,3 r=2\n"
    "ball b at=20,15 v=-5,4 r=2\n";

struct Event {
    double seconds = 0.0;
    char code = 0;
    std::string data;
};

/// Decodes the JSON string that starts at `at`. Knows only the escapes that carom writes.
std::string unquoted(const std::string& line, std::size_t at) {
    REQUIRE(line[at] == '"');
    std::string text;
    for (++at; line[at] != '"'; ++at) {
        REQUIRE(static_cast<unsigned char>(line[at]) >= 0x20);
        if (line[at] != '\\') {
            text += line[at];
            continue;
        }
        const char escaped = line[++at];
        const auto plain = std::string("\"\\nrt").find(escaped);
        if (plain != std::string::npos) {
            text += "\"\\\n\r\t"[plain];
            continue;
        }
        REQUIRE(escaped == 'u');
        text += static_cast<char>(std::stoi(line.substr(at + 1, 4), nullptr, 16));
        at += 4;
    }
    return text;
}

struct Film {
    std::string header;
    std::vector<Event> events;

    explicit Film(const std::string& text) {
        REQUIRE(text.ends_with('\n'));
        for (std::size_t from = 0; from < text.size();) {
            const std::size_t end = text.find('\n', from);
            const std::string line = text.substr(from, end - from);
            from = end + 1;
            if (header.empty()) {
                header = line;
                continue;
            }
            const std::size_t code = line.find(", \"");
            const std::size_t data = line.find(", \"", code + 1);
            REQUIRE((line.starts_with('[') && line.ends_with("\"]")));
            events.push_back({std::stod(line.substr(1)), line[code + 3], unquoted(line, data + 2)});
        }
    }

    /// The final picture of a playback in a terminal of the header's size.
    Emulator played() const {
        const auto number = [&](const char* key) {
            return std::stoi(header.substr(header.find(key) + std::string(key).size()));
        };
        Emulator emulator(number("\"width\": "), number("\"height\": "), {},
                          [](std::string_view) { FAIL("the film asks the terminal something"); });
        double last = 0.0;
        for (const Event& event : events) {
            CHECK(event.seconds >= last);
            last = event.seconds;
            if (event.code == 'o') emulator.write(event.data);
            if (event.code == 'r')
                emulator.resize(std::stoi(event.data),
                                std::stoi(event.data.substr(event.data.find('x') + 1)));
        }
        return emulator;
    }
};

/// All cells of a screen as text, equal for cells that look alike.
std::vector<std::string> seen(const Emulator& screen) {
    std::vector<std::string> cells;
    for (int row = 0; row < screen.rows(); ++row)
        for (int column = 0; column < screen.columns(); ++column)
            cells.push_back(described(screen.look(column, row)));
    return cells;
}

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

}  // namespace

TEST_CASE("the lines of an asciinema recording are JSON, whatever is shown") {
    CHECK(asciinema_header({.columns = 80, .rows = 24, .title = "a \"b\"", .terminal = "xterm"}) ==
          "{\"version\": 2, \"width\": 80, \"height\": 24, \"title\": \"a \\\"b\\\"\", "
          "\"env\": {\"TERM\": \"xterm\"}}\n");
    CHECK(asciinema_header({.columns = 1, .rows = 2, .title = "", .terminal = ""}) ==
          "{\"version\": 2, \"width\": 1, \"height\": 2, \"title\": \"\"}\n");
    CHECK(asciinema_event(1.25, 'o', "\033[1m\\▀\r\n\"") ==
          "[1.250000, \"o\", \"\\u001b[1m\\\\▀\\r\\n\\\"\"]\n");
    CHECK(asciinema_event(0.0, 'r', "80x24") == "[0.000000, \"r\", \"80x24\"]\n");
    CHECK(asciinema_event(0.0, 'o', "\xe2\x96") == "[0.000000, \"o\", \"\uFFFD\uFFFD\"]\n");
}

TEST_CASE("an asciinema recording has sizes and times from its first picture on") {
    const TemporaryFolder folder;
    const std::string file = folder.path("a.cast");
    AsciinemaRecording cast(file, "title", "");
    REQUIRE_FALSE(cast.obstacle());
    cast.add(100.0, 80, 24, "one");
    cast.add(100.5, 80, 24, "two");
    cast.add(101.0, 90, 25, "three");
    CHECK(folder.names().size() == 1);  // the temporary file
    CHECK(folder.names().front() != "a.cast");
    REQUIRE_FALSE(cast.finish(102.0));
    CHECK(folder.names() == std::vector<std::string>{"a.cast"});
    CHECK(content(file) ==
          "{\"version\": 2, \"width\": 80, \"height\": 24, \"title\": \"title\"}\n"
          "[0.000000, \"o\", \"\\u001b[?25l\"]\n"
          "[0.000000, \"o\", \"one\"]\n"
          "[0.500000, \"o\", \"two\"]\n"
          "[1.000000, \"r\", \"90x25\"]\n"
          "[1.000000, \"o\", \"three\"]\n"
          "[2.000000, \"o\", \"\\u001b[m\\u001b[25;1H\\u001b[?25h\"]\n");
}

TEST_CASE("an asciinema recording without a picture, or not finished, leaves no file") {
    const TemporaryFolder folder;
    const std::string old = folder.file("old.cast", "precious");
    {
        AsciinemaRecording cast(old, "", "");
        cast.add(0.0, 80, 24, "one");
    }
    CHECK_FALSE(AsciinemaRecording(old, "", "").finish(1.0));
    CHECK(content(old) == "precious");
    CHECK(folder.names().size() == 1);
}

TEST_CASE("an asciinema recording on a full disk is reported") {
    AsciinemaRecording cast("/dev/full", "", "");
    REQUIRE_FALSE(cast.obstacle());
    cast.add(0.0, 80, 24, "one");
    CHECK(cast.finish(1.0).value_or("").find("'/dev/full'") != std::string::npos);
}

TEST_CASE("the playback of an asciinema recording shows the screen, however the game ended") {
    const TemporaryFolder folder;
    const std::string level_file = folder.file("two.level", level);
    const std::string file = folder.path("a.cast");
    std::string look;
    int ending = 0;
    bool is_suspended = false;
    SUBCASE("half blocks") {
        look = "half";
    }
    SUBCASE("ASCII") {
        look = "ascii";
    }
    SUBCASE("braille, terminated") {
        look = "braille";
        ending = SIGTERM;
    }
    SUBCASE("suspended, and hung up") {
        look = "half";
        is_suspended = true;
        ending = SIGHUP;
    }
    ProgramOptions options = at_home(folder);
    options.emulator.has_synchronized_output = true;
    TerminalProgram game({CAROM_BINARY_DIR "/carom", "play", level_file, "--paused", "--renderer",
                          look, "--cast", file},
                         options);
    REQUIRE(game.wait_for_text("tick 0"));
    game.send("c>");
    REQUIRE(game.wait_for_text("tick 120"));
    game.resize(110, 30);
    game.settle();
    game.send("?");
    REQUIRE(game.wait_for_text("back to the game"));
    game.send("x");
    if (is_suspended) {
        game.send("\x1a");
        // Nobody could continue it, so the system does so at once.
        const auto has_left = [&] {
            return game.output().find("\033[?1049l") != std::string::npos;
        };
        REQUIRE(game.wait_until([&] { return has_left() && game.screen().mode(1049); }));
    }
    game.send(".");
    REQUIRE(game.wait_for_text("tick 121"));
    game.settle(0.3);
    const std::string text = game.screen().text();
    const std::vector<std::string> cells = seen(game.screen());
    CHECK_FALSE(has(folder.names(), "a.cast"));  // until it is complete
    if (ending == 0)
        game.send("q");
    else
        game.signal(ending);
    REQUIRE(game.wait_for_end());
    CHECK(game.what_is_left_dirty().empty());
    CHECK(has(folder.names(), "a.cast"));

    const Film film(content(file));
    CHECK(film.header.find("\"title\": \"carom play two.level\"") != std::string::npos);
    CHECK(film.header.find("\"env\": {\"TERM\": \"xterm-256color\"}") != std::string::npos);
    const Emulator played = film.played();
    CHECK(played.columns() == 110);
    CHECK(played.text() == text);
    CHECK((seen(played) == cells));
    CHECK(played.mode(25));  // the cursor is visible again
    CHECK_FALSE(played.mode(1049));
    CHECK_FALSE(played.mode(1002));
}

TEST_CASE("an asciinema recording that cannot be written is reported before the game") {
    const TemporaryFolder folder;
    const std::string level_file = folder.file("two.level", level);
    for (const std::string& place :
         {folder.path(), std::string("/proc/a.cast"), std::string("-")}) {
        TerminalProgram game({CAROM_BINARY_DIR "/carom", "play", level_file, "--cast", place},
                             at_home(folder));
        CHECK(game.wait_for_end());
        CHECK(game.output().find("carom: error: ") != std::string::npos);
        CHECK(game.output().find("\033[?1049h") == std::string::npos);
    }
}
