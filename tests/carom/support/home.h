#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "carom/play/program.h"

namespace carom::test {

inline std::string contents(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// A user's home, with a folder of levels in which the program runs; all of it is deleted at the
/// end.
struct Home {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("carom-home-" + std::to_string(::getpid()));
    std::filesystem::path before = std::filesystem::current_path();
    Home() {
        std::filesystem::create_directories(path / "work");
        std::filesystem::current_path(path / "work");
        ::setenv("XDG_CONFIG_HOME", (path / "config").c_str(), 1);
        ::setenv("XDG_STATE_HOME", (path / "state").c_str(), 1);
        ::setenv("XDG_DATA_HOME", (path / "data").c_str(), 1);
    }
    Home(const Home&) = delete;
    Home& operator=(const Home&) = delete;
    ~Home() {
        std::filesystem::current_path(before);
        std::filesystem::remove_all(path);
        ::unsetenv("XDG_CONFIG_HOME");
        ::unsetenv("XDG_STATE_HOME");
        ::unsetenv("XDG_DATA_HOME");
    }
    void write(const char* name, const std::string& text) const { std::ofstream(name) << text; }
    std::filesystem::path preferences() const { return path / "config/carom/preferences"; }
};

/// The program with a window of 120x30, without a terminal.
struct Running {
    Program program;
    Canvas window{120, 30};
    double now = 100.0;

    explicit Running(const PlayOptions& options, const std::string& preferences = {})
        : program(options, read_preferences(preferences, "preferences")) {
        Capabilities capabilities;
        capabilities.colors = 256;
        capabilities.utf8 = true;
        program.set_capabilities(capabilities);
    }
    void key(char32_t code, std::uint8_t modifiers = no_modifier) {
        InputEvent event;
        event.key = code;
        event.modifiers = modifiers;
        program.handle(event, now);
    }
    void pass(double seconds) {
        now += seconds;
        program.advance(seconds, now, [] { return true; });
    }
    std::string look() {
        program.draw(window);
        return window.text();
    }
    bool sees(const std::string& text) { return look().find(text) != std::string::npos; }
};

}  // namespace carom::test
