#pragma once

#include <doctest/doctest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "carom/play/program.h"
#include "carom/support/person.h"
#include "level/load.h"

/// A player at a pinball table, with folders of its own.
namespace carom::test {

// Of the 40 rows of the window, three show the status.
inline constexpr int table_rows = 37;

// Only the player moves anything: one ball rests on the plunger in the lane at the right, and one
// beneath the bumper waits for a push.
inline const char* const level = R"(carom 1 "A small table"
units mm
rate 1000
use spin
kind pinball r=10 m=80g
box 0,0 400,600 r=1
ball b kind=pinball at=380,31
ball c kind=pinball at=200,440
bumper pops at=200,500 r=20 kick=0.8m/s
hole cellar at=100,300 toward=200,400 speed=0.1m/s hold=1s r=8
plunger spring at=380,20 dir=up speed=0.5m/s..2.5m/s width=10
drain out 10,10 20,10 r=3
flipper left at=60,60 length=90 r=8
flipper right at=250,60 length=90 r=8 key=right
game pinball save=0s highscores=3
)";

// The ball crosses a lane and drains: the game is over.
inline const char* const short_game = R"(carom 1 "A short game"
units mm
rate 1000
use gravity 0,-0.8m/s2
kind pinball r=10 m=80g
box 0,0 400,600 r=1
ball b kind=pinball at=380,31
rollover lane at=380,200 r=15
plunger spring at=380,20 dir=up speed=2.5m/s..2.5m/s width=10
drain out 350,320 399,320
flipper left at=60,60 length=90 r=8
flipper right at=250,60 length=90 r=8 key=right
game pinball balls=1 save=0s highscores=3
on lane enter score 700
)";

inline std::string looks_of(const Cell& cell) {
    return std::to_string(cell.glyph) + ' ' + std::to_string(cell.foreground) + ' ' +
           std::to_string(cell.background) + ';';
}

inline InputEvent mouse(InputEvent::Action action, std::uint8_t button = 1) {
    InputEvent event;
    event.kind = InputEvent::Kind::mouse;
    event.action = action;
    event.button = button;
    return event;
}

inline Session session_of(const char* text) {
    LoadResult loaded = load_level(text, "table", {});
    REQUIRE(loaded.scene.has_value());
    const SolverSettings solver = pick_solver(loaded.scene->world).settings;
    return Session(std::move(*loaded.scene), solver);
}

/// A user's folders, deleted at the end of the test.
struct TableHome {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("carom-table-" + std::to_string(::getpid()));
    TableHome() {
        std::filesystem::create_directories(path / "data/carom");
        ::setenv("XDG_CONFIG_HOME", (path / "config").c_str(), 1);
        ::setenv("XDG_STATE_HOME", (path / "state").c_str(), 1);
        ::setenv("XDG_DATA_HOME", (path / "data").c_str(), 1);
        write("work.level", level);
    }
    ~TableHome() {
        std::filesystem::remove_all(path);
        for (const char* const name : {"XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_DATA_HOME"})
            ::unsetenv(name);
    }
    void write(const char* name, const std::string& text) const {
        std::ofstream(path / name) << text;
    }
    std::string table() const { return (path / "work.level").string(); }
};

struct AtTable {
    Program program;
    Canvas window{120, 40};
    double now = 100.0;

    explicit AtTable(const TableHome& home, bool key_release = false, bool watch = false,
                     const char* preferences = "", bool resume = false,
                     std::vector<std::string> set = {},
                     std::optional<SolverSettings> solver = std::nullopt)
        : program(
              [&] {
                  PlayOptions options;
                  options.level = home.table();
                  options.watch = watch;
                  options.resume = resume;
                  options.overrides = std::move(set);
                  options.solver = solver;
                  return options;
              }(),
              read_preferences(preferences, "preferences")) {
        Capabilities capabilities;
        capabilities.columns = 120;
        capabilities.rows = 40;
        capabilities.colors = 256;
        capabilities.utf8 = true;
        capabilities.key_release = key_release;
        program.set_capabilities(capabilities);
        REQUIRE_FALSE(program.start().has_value());
        look();
    }
    void key(char32_t code, InputEvent::Action action = InputEvent::Action::press) {
        InputEvent event;
        event.key = code;
        event.action = action;
        program.handle(event, now);
    }
    void pass(double seconds) {
        for (double left = seconds; left > 1e-9; left -= 0.01) {
            now += 0.01;
            program.advance(0.01, now, always);
        }
    }
    std::string look() {
        program.draw(window);
        return window.text();
    }
    bool sees(const std::string& text) { return look().find(text) != std::string::npos; }
    /// The table, without the panel and the lines below it.
    std::size_t picture() {
        look();
        std::string rows;
        for (int row = 0; row < table_rows; ++row)
            for (int column = 0; column < 80; ++column)
                rows += looks_of(window.at(column, row));
        return std::hash<std::string>{}(rows);
    }
};

}  // namespace carom::test
