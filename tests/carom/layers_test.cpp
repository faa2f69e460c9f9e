#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "carom/support/process.h"

// The layers of docs/architecture.md: which may include which, and what the deterministic core may
// not use.

namespace {

namespace fs = std::filesystem;

struct Source {
    std::string layer;
    std::string name;
    std::vector<std::string> lines;
};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::size_t from = 0;
    while (from < text.size()) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        lines.push_back(text.substr(from, end - from));
        from = end + 1;
    }
    return lines;
}

std::vector<Source> sources() {
    std::vector<Source> found;
    const fs::path root = fs::path(CAROM_SOURCE_DIR) / "src";
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        const fs::path name = entry.path().lexically_relative(root);
        if (!entry.is_regular_file() || !name.has_parent_path()) continue;
        found.push_back({.layer = name.begin()->string(),
                         .name = name.string(),
                         .lines = lines_of(carom::test::content(entry.path().string()))});
    }
    std::ranges::sort(found, {}, &Source::name);
    return found;
}

// The text between the quotes or brackets of an #include; empty: the line is not one.
std::string included(const std::string& line) {
    if (!line.starts_with("#include")) return {};
    const std::size_t open = line.find_first_of("\"<");
    const std::size_t close = line.find_first_of("\">", open + 1);
    return line.substr(open + 1, close - open - 1);
}

bool is_name_part(char c) {
    return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// Finds the word as a whole word, outside comments.
bool uses(std::string_view line, std::string_view word) {
    line = line.substr(0, line.find("//"));
    for (std::size_t at = line.find(word); at != line.npos; at = line.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !is_name_part(line[at - 1])) &&
            (end == line.size() || !is_name_part(line[end]))) {
            return true;
        }
    }
    return false;
}

// The name of the type that the line starts to define at the outermost level; empty: none.
std::string defined_type(const std::string& line) {
    for (const std::string_view keyword : {"struct ", "class ", "enum class ", "enum "}) {
        if (!line.starts_with(keyword)) continue;
        std::size_t begin = keyword.size();
        if (line.compare(begin, 8, "alignas(") == 0) begin = line.find(") ", begin) + 2;
        std::size_t end = begin;
        while (end < line.size() && (is_name_part(line[end]) || line[end] == ':'))
            ++end;  // including the type that it is nested in
        const bool is_declared_only = end < line.size() && line[end] == ';';
        return is_declared_only ? "" : line.substr(begin, end - begin);
    }
    return {};
}

const std::map<std::string, std::vector<std::string>> may_include{
    {"geometry", {"geometry"}},
    {"physics", {"geometry", "physics"}},
    {"level", {"geometry", "physics", "level"}},
    {"game", {"geometry", "physics", "level", "game"}},
    {"lab", {"geometry", "physics", "level", "game", "lab"}},
    {"terminal", {"geometry", "physics", "level", "game", "terminal"}},
    {"carom", {"geometry", "physics", "level", "game", "lab", "terminal", "carom"}},
};

// Rooms in the order in which they build on one another: each includes only its own files and those
// of rooms above it. A layer's own files, outside of its rooms, come last in the layer, except for
// the leaves of `lab` and `game`.
const std::vector<std::string> rooms{
    "geometry",
    "physics/memory",
    "physics/world",
    "physics/broad_phase",
    "physics/laws",
    "physics/tick",
    "physics/ccd",
    "physics/discrete",
    "physics/contact",
    "physics/swept",
    "physics/event/motion",
    "physics/event/rest",
    "physics/event/impact",
    "physics/event/schedule",
    "physics/event",
    "physics",
    "level/scene",
    "level/text",
    "level/values",
    "level/language",
    "level/ir",
    "level/statements",
    "level/build",
    "level/fill",
    "level/assemble",
    "level",
    "game",
    "game/referees",
    "game/commands",
    "game/rules",
    "game/pool",
    "game/pinball",
    "game/shots",
    "game/session",
    "game/ai",
    "game/replay",
    "lab",
    "lab/observe",
    "lab/run",
    "lab/measure",
    "lab/compare",
    "lab/games",
    "terminal/canvas",
    "terminal/draw",
    "terminal/panels",
    "terminal/input",
    "terminal/screen",
    "terminal/process",
    "carom/text",
    "carom/options",
    "carom/files",
    "carom/context",
    "carom/pool",
    "carom/controllers",
    "carom/play",
    "carom/cli",
    "carom",
};

// The largest number of files in a folder; in a larger one nobody finds anything.
constexpr std::size_t most_files_in_a_room = 40;

const std::vector<std::string> core{"geometry", "physics", "level", "game"};

}  // namespace

TEST_CASE("a layer includes only layers to its left") {
    for (const Source& source : sources()) {
        CAPTURE(source.name);
        const auto allowed = may_include.find(source.layer);
        REQUIRE(allowed != may_include.end());
        for (const std::string& line : source.lines) {
            const std::string file = included(line);
            const std::string layer = file.substr(0, file.find('/'));
            if (!may_include.contains(layer)) continue;
            CAPTURE(line);
            CHECK(std::ranges::find(allowed->second, layer) != allowed->second.end());
        }
    }
}

TEST_CASE("a room includes only rooms above it") {
    const auto place_of = [](const std::string& file) {
        return std::ranges::find(rooms, file.substr(0, file.rfind('/'))) - rooms.begin();
    };
    for (const Source& source : sources()) {
        CAPTURE(source.name);
        const auto own = place_of(source.name);
        REQUIRE(own < std::ssize(rooms));
        for (const std::string& line : source.lines) {
            const std::string file = included(line);
            if (!may_include.contains(file.substr(0, file.find('/')))) continue;
            CAPTURE(line);
            CHECK(place_of(file) <= own);
        }
    }
}

TEST_CASE("only the physics writes to a world without stamping it") {
    for (const Source& source : sources()) {
        if (source.layer == "physics") continue;
        CAPTURE(source.name);
        for (const std::string& line : source.lines)
            CHECK(included(line) != "physics/world/solver_access.h");
    }
}

TEST_CASE("a room has few enough files to survey") {
    std::map<std::string, std::size_t> files;
    for (const Source& source : sources())
        ++files[source.name.substr(0, source.name.rfind('/'))];
    for (const auto& room : files) {
        INFO(room.first, " has ", room.second, " files");
        CHECK(room.second <= most_files_in_a_room);
    }
}

TEST_CASE("only the screen includes ncurses") {
    for (const Source& source : sources()) {
        if (source.name.starts_with("terminal/screen/")) {
            continue;
        }
        CAPTURE(source.name);
        for (const std::string& line : source.lines) {
            const std::string file = included(line);
            CHECK(file.find("curses") == file.npos);
            CHECK(file != "term.h");
        }
    }
}

TEST_CASE("the core uses nothing that differs between machines or runs") {
    const std::vector<std::string> headers{
        "chrono",        "random",     "thread", "iostream", "fstream",   "unordered_map",
        "unordered_set", "filesystem", "future", "mutex",    "locale",    "ctime",
        "time.h",        "execution",  "regex",  "atomic",   "pthread.h", "condition_variable"};
    const std::vector<std::string> words{
        "std::sin",  "std::cos",  "std::tan",    "std::atan",   "std::atan2", "std::asin",
        "std::acos", "std::pow",  "std::exp",    "std::log",    "std::hypot", "std::fma",
        "std::exp2", "std::cbrt", "std::log2",   "std::log10",  "std::sinh",  "std::cosh",
        "std::tanh", "std::erf",  "std::tgamma", "std::rand",   "rand",       "strtod",
        "std::stod", "atof",      "sscanf",      "std::getenv", "std::time",  "std::hash",
        "__int128",  "float",     "setlocale"};
    for (const Source& source : sources()) {
        if (std::ranges::find(core, source.layer) == core.end()) continue;
        CAPTURE(source.name);
        for (const std::string& line : source.lines) {
            CAPTURE(line);
            // Stamps are assigned in several threads, but no result depends on their values.
            const bool is_stamp = source.name == "physics/world/stamp.cpp";
            if (!is_stamp || included(line) != "atomic")
                CHECK(std::ranges::find(headers, included(line)) == headers.end());
            for (const std::string& word : words)
                CHECK_FALSE(uses(line, word));
        }
    }
}

// All layers share one namespace. Two types with one name in it are undefined behaviour that no
// compiler reports, since no file sees both.
TEST_CASE("a type name in a header denotes one type") {
    std::map<std::string, std::string> defined_in;
    for (const Source& source : sources()) {
        if (!source.name.ends_with(".h")) continue;
        for (const std::string& line : source.lines) {
            const std::string type = defined_type(line);
            if (type.empty()) continue;
            const auto stored = defined_in.emplace(type, source.name);
            INFO(type, " stands in ", stored.first->second, " and in ", source.name);
            CHECK(stored.second);
        }
    }
}
