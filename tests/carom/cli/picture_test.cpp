#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "carom/support/process.h"

using namespace carom::test;

namespace {

const char* const falling =
    "carom 1 \"Falling\"\n"
    "use gravity 0,-10\n"
    "edge 0,0 40,0 40,40 0,40 close\n"
    "ball a at=20,30 r=3\n";

namespace fs = std::filesystem;

// A call of carom in a document, and what the document has of its output: a file, or the text of
// the fenced block that follows.
struct Call {
    std::vector<std::string> arguments;
    std::string file;
    std::string text;
};

std::optional<Call> call_in(const std::string& line) {
    constexpr std::string_view opening = "<!-- carom picture ";
    constexpr std::string_view closing = " -->";
    if (!line.starts_with(opening) || !line.ends_with(closing)) return std::nullopt;
    std::istringstream words(
        line.substr(opening.size(), line.size() - opening.size() - closing.size()));
    Call call{{"picture"}, {}, {}};
    for (std::string word; words >> word;) {
        if (word == "--output")
            words >> call.file;
        else
            call.arguments.push_back(word);
    }
    return call;
}

std::vector<Call> calls_in(const fs::path& document) {
    std::vector<Call> calls;
    std::istringstream lines(content(document.string()));
    for (std::string line; std::getline(lines, line);) {
        std::optional<Call> call = call_in(line);
        if (!call) continue;
        if (call->file.empty()) {
            REQUIRE(std::getline(lines, line));
            REQUIRE(line == "```text");
            while (std::getline(lines, line) && line != "```")
                call->text += line + "\n";
        }
        calls.push_back(*std::move(call));
    }
    return calls;
}

}  // namespace

// If a change alters them on purpose: scripts/update pictures.
TEST_CASE("the pictures of README and manual show what carom draws") {
    const fs::path root = CAROM_SOURCE_DIR;
    std::vector<fs::path> documents{root / "README.md"};
    for (const auto& entry : fs::directory_iterator(root / "docs"))
        if (entry.path().extension() == ".md") documents.push_back(entry.path());
    std::vector<std::string> files;
    for (const fs::path& document : documents)
        for (const Call& call : calls_in(document)) {
            CAPTURE(document.string());
            CAPTURE(call.file);
            const auto drawn = run_carom(call.arguments);
            CHECK(drawn.exit_code == 0);
            const std::string shown =
                call.file.empty() ? call.text : content((root / call.file).string());
            CHECK(drawn.out == shown);
            if (!call.file.empty()) files.push_back((root / call.file).string());
        }
    CHECK(files.size() >= 3);
    // No picture is left that no document makes.
    for (const auto& entry : fs::directory_iterator(root / "docs" / "pictures"))
        CHECK(std::ranges::count(files, entry.path().string()) == 1);
}

TEST_CASE("carom picture writes what the screen would show, as text, ANSI or SVG") {
    const TemporaryFolder folder;
    const std::string level = folder.file("falling.level", falling);
    const auto start = run_carom({"picture", level, "--size", "60x20", "--format", "text"});
    CHECK(start.exit_code == 0);
    CHECK(std::ranges::count(start.out, '\n') == 20);
    CHECK(has(start.out, "Falling"));
    CHECK_FALSE(has(start.out, "\x1b"));
    CHECK(std::ranges::all_of(start.out, [](char byte) { return byte >= 0; }));
    // Later the ball is elsewhere; the same call makes the same picture.
    const auto later = run_carom({"picture", level, "--size=60x20", "--format=text", "--time=5"});
    CHECK(later.out != start.out);
    CHECK(has(later.out, "5.000 s"));
    CHECK(run_carom({"picture", level, "--size=60x20", "--format=text", "--time=5"}).out ==
          later.out);

    const auto ansi = run_carom({"picture", level, "--renderer", "half", "--colors", "256"});
    CHECK(has(ansi.out, "\x1b[38;5;"));
    CHECK(std::ranges::count(ansi.out, '\n') == 24);

    const std::string file = folder.path("a.svg");
    const auto svg =
        run_carom({"picture", level, "--renderer=octants", "--format=svg", "--output", file});
    CHECK(svg.exit_code == 0);
    CHECK(svg.out.empty());
    CHECK(content(file).starts_with("<svg "));
    CHECK(content(file).ends_with("</svg>\n"));
}

TEST_CASE("the first picture of a game by a level's own rules is of its first turn") {
    const TemporaryFolder folder;
    const std::string level = folder.file("golf.level",
                                          "carom 1 \"Golf\"\n"
                                          "use cloth slide=0.2 roll=0.01 spin=10 g=9.81\n"
                                          "world 0,0 10,5\n"
                                          "ball white at=5,2 r=0.2\n"
                                          "pocket cup at=9,4 r=0.3\n"
                                          "cue ball=white power=0..5\n"
                                          "game shots\n"
                                          "var par\n"
                                          "on turn begins  par 3\n"
                                          "on white pocketed  end\n"
                                          "task \"PAR {par}\" if par=3\n");
    const auto drawn = run_carom({"picture", level, "--format", "text"});
    CAPTURE(drawn.err);
    CHECK(has(drawn.out, "PAR 3"));
}

TEST_CASE("a panel says when it begins, and counts stand in the histogram or over the bins") {
    const auto shown = [](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "picture");
        arguments.insert(arguments.end(), {"--format=text", "--time=1"});
        return run_carom(arguments).out;
    };
    CHECK(has(shown({"two-posts"}), "Lyapunov exponent  from 2 s on"));
    // A ball falls into the left one of two bins.
    const TemporaryFolder folder;
    const std::string bins =
        "carom 1 \"Bins\"\nuse gravity 0,-10\nworld 0,-3 20,9\n"
        "bins at=10,2 count=2 width=10 depth=4 wall=0.1\nball a at=5,1 r=0.5\n";
    const std::string plain = folder.file("bins.level", bins);
    const std::string with_panel =
        folder.file("panel.level", bins + "show histogram of=bins against=binomial(1,0.5)\n");
    const auto counted = [](const std::string& text) {
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);)
            if (line.ends_with(" 1") && line.find_first_not_of(' ') == line.size() - 1) return true;
        return false;
    };
    CHECK(counted(shown({plain})));
    CHECK_FALSE(counted(shown({with_panel})));
}

TEST_CASE("carom picture says what is wrong, and leaves no file behind") {
    const TemporaryFolder folder;
    const std::string level = folder.file("bad.level", "carom 1 \"Bad\"\nbal a\n");
    const std::string file = folder.path("a.svg");
    const auto bad = run_carom({"picture", level, "--output", file});
    CHECK(bad.exit_code == 2);
    CHECK(has(bad.err, "bad.level:2:1: error:"));
    CHECK(folder.names() == std::vector<std::string>{"bad.level"});
    for (const auto* size : {"0x5", "12", "x", "5x", "9999x5", "5x5x5", "-5x5"}) {
        const auto wrong = run_carom({"picture", level, "--size", size});
        CHECK(wrong.exit_code == 2);
        CHECK(has(wrong.err, "--size must be columns and rows"));
    }
    const auto format = run_carom({"picture", level, "--format", "png"});
    CHECK(has(format.err, "--format must be one of svg, ansi, text"));
}
