#include <doctest/doctest.h>

#include "level/support/files.h"
#include "level/text/reporter.h"
#include "level/text/utf8.h"
#include "support/sanitizers.h"

using namespace carom;
using namespace carom::test;

namespace {

std::string repeated(std::string_view text, int count) {
    std::string result;
    for (int i = 0; i < count; ++i)
        result += text;
    return result;
}

// Checks for exactly one error, with these words.
void check_refused(const LoadResult& result, std::string_view words) {
    CAPTURE(words);
    CHECK_FALSE(result.scene);
    REQUIRE(result.diagnostics.size() == 1);
    CHECK(result.diagnostics[0].message.find(words) != std::string::npos);
}

}  // namespace

TEST_CASE("a million balls load, and one more is an error") {
    if (!has_sanitizers) {
        const LoadResult most = load_lines("fill count=1e6 box=0,0,3300,3300 r=1\n");
        REQUIRE(most.scene);
        CHECK(most.scene->world.balls().size() == 1'000'000);
    }
    check_refused(load_lines("ball at=-9,0\nfill count=1e6 box=0,0,3300,3300 r=1\n"),
                  "more than 1000000 balls");
    check_refused(load_lines("kind k\nspawn k at=0,0 every=1 count=999999\nball at=9,0\n"
                             "ball at=20,0\n"),
                  "more than 1000000 balls");
}

TEST_CASE("short levels that expand without bound are refused") {
    check_refused(load_lines("repeat 1e9\nend\n"), "more than 1000000 statements");
    check_refused(
        load_lines("part a\n" + repeated("place a at=1,1\n", 10) + "end\nplace a at=0,0\n"),
        "nested deeper than 32");
    std::string doubling = "part p0\n peg at=0,0 r=1\nend\n";
    for (int i = 1; i <= 30; ++i) {
        const std::string inner = "place p" + std::to_string(i - 1) + " at=1,1\n";
        doubling += "part p" + std::to_string(i) + "\n" + inner + inner + "end\n";
    }
    check_refused(load_lines(doubling + "place p30 at=0,0\n"), "more than 1000000 statements");
    check_refused(
        load_lines("repeat 1000\npegs grid at=0,0 rows=1000 columns=1000 pitch=1 r=0\nend\n"),
        "more than 1000000 edges");
    check_refused(load_lines(repeated("fill count=1 box=0,0,9,9 r=0.001\n", 1001)),
                  "more than 1000 fills");
}

TEST_CASE("short levels that repeat much are refused") {
    if (has_sanitizers) return;  // slow; other tests read maps, long lines and nested blocks
    check_refused(
        load_lines(repeated("repeat 100\n", 30) + "peg at=0,0 r=1\n" + repeated("end\n", 30)),
        "more than 1000000 statements");
    const std::string long_line = "edge" + repeated(" 0,0 \\\n 1,1 \\\n", 100'000) + "\n";
    check_refused(load_lines("repeat 1e6\n" + long_line + "end\n"), "more than 1000000");
    check_refused(load_lines("repeat 1e5\nmap cell=1\n" + repeated(repeated(" ", 4000) + "\n", 10) +
                             "end\nend\n"),
                  "too much work");
}

TEST_CASE("a million copies of one error give one message") {
    const LoadResult result = load_lines("repeat 900000\n peg at=0,W r=1\nend\n");
    check_refused(result, "'W' is not known");
}

TEST_CASE("blocks, brackets and includes nest up to 32 deep") {
    const auto nested = [](int depth) {
        return repeated("mirror x=0\n", depth) + "peg at=0,0 r=1\n" + repeated("end\n", depth);
    };
    CHECK(
        load_lines(repeated("repeat 1\n", 32) + "peg at=0,0 r=1\n" + repeated("end\n", 32)).scene);
    check_refused(load_lines(nested(33)), "nested deeper than 32");
    check_refused(load_lines(nested(100'000)), "nested deeper than 32");
    const auto bracketed = [](int depth) {
        return "peg at=" + repeated("(", depth) + "1" + repeated(")", depth) + ",0 r=1\n";
    };
    CHECK(load_lines(bracketed(32)).scene);
    check_refused(load_lines(bracketed(33)), "nested deeper than 32");
    check_refused(load_lines("peg at=" + repeated("2^", 1000) + "2,0 r=1\n"), "nested deeper");
    LoadOptions options;
    int number = 0;
    options.resolve_include = [&](std::string_view, std::string_view) {
        ++number;
        return std::optional(IncludedFile{"f" + std::to_string(number), "include \"next\"\n"});
    };
    check_refused(load_lines("include \"f\"\n", options), "includes are nested deeper than 32");
    CHECK(number <= 33);
}

// Regression: image numbers were powers of four, which overflowed.
TEST_CASE("nested mirrors reach the limit without overflow") {
    const LoadResult result =
        load_lines(repeated("mirror x=0 y=0\n", 32) + "peg at=0,0 r=1\n" + repeated("end\n", 32));
    check_refused(result, "more than 1000000 statements");
}

TEST_CASE("files and lines have a largest size") {
    const std::string head = "carom 1 \"A\"\n";
    const auto load = [](const std::string& text) { return load_level(text, "a.level"); };
    CHECK(load(head + repeated("# 123456789\n", 300'000)).scene);
    check_refused(load(head + repeated("# 123456789\n", 400'000)), "more than 4 MiB");
    CHECK(load(head + "#" + repeated("x", 4095)).scene);
    check_refused(load(head + "#" + repeated("x", 4096)), "more than 4096");
}

TEST_CASE("an overlap among 250,000 balls is found without testing all pairs") {
    // A grid of touching balls, and one ball that overlaps the last by a tenth.
    const LoadResult result = load_lines(
        "repeat 500 step=0,2\n repeat 500 step=2,0\n  ball at=0,0 r=1\n end\nend\n"
        "ball at=998,999.9 r=1\n");
    REQUIRE(result.diagnostics.size() == 1);
    CHECK(result.diagnostics[0].line == 7);
}

TEST_CASE("many balls in one place that do not collide load quickly") {
    CHECK(load_lines("collide ball edge\nrepeat 100000\n ball at=0,0\nend\n").scene);
    // Red collides with blue only, but all pairs are near: the check gives up with a warning.
    const LoadResult result = load_lines(
        "kind red\nkind blue\ncollide red blue\n"
        "repeat 50000\n ball at=0,0 kind=red\nend\nball at=9,9 kind=blue\n");
    CHECK(result.scene);
    REQUIRE(result.diagnostics.size() == 1);
    CHECK(result.diagnostics[0].severity == Severity::warning);
}

// Regression: each of these took minutes, since all items in one place are near each other.
TEST_CASE("crowds of items that hardly collide load in bounded time" *
          doctest::skip(has_sanitizers)) {
    const std::string edges = "repeat 100000\n edge -1,0 1,0\nend\n";
    const LoadResult ghosts = load_lines(
        "kind red\nkind blue\ncollide red blue\nball at=9,9 kind=blue\n"
        "repeat 100000\n ball at=0,0 kind=red\nend\n" +
        edges);
    CHECK(ghosts.scene);
    REQUIRE(ghosts.diagnostics.size() == 2);
    CHECK(ghosts.diagnostics[0].message.find("too crowded to check how its balls start") !=
          std::string::npos);
    CHECK(ghosts.diagnostics[1].message.find("too crowded to look for gaps") != std::string::npos);
    const std::string diagonals = "repeat 100000\n edge -100,-100 100,100\nend\n";
    check_refused(load_lines(diagonals + "fill count=200000 box=-100,-100,100,100 r=0.01\n"),
                  "too much work");
    check_refused(load_lines("fill count=20000 box=0,0,3000,3000\n" +
                             repeated("fill count=1 box=0,0,3000,3000\n", 999)),
                  "too much work");
}

// Regression: each of these files, below 1 MB, took from 1.7 to more than 40 seconds, or gigabytes.
TEST_CASE("short files of costly statements are refused for their work" *
          doctest::skip(has_sanitizers)) {
    const auto list = [](std::string_view text, int count, std::string_view separator) {
        return repeated(std::string(text) + std::string(separator), count - 1) + std::string(text);
    };
    const auto refuse = [](const std::string& lines) {
        check_refused(load_lines(lines), "too much work");
    };
    refuse("repeat 20000\npeg at=" + list("1", 1900, "+") + ",0 r=1\nend\n");
    std::string part = "part p";
    for (int i = 0; i < 500; ++i)
        part += " k" + std::to_string(i) + "=1";
    refuse(part + "\nend\nrepeat 400000\nplace p at=0,0\nend\n");
    std::string lets = "let";
    for (int i = 0; i < 60'000; ++i)
        lets += " a" + std::to_string(i) + "=1 \\\n";
    refuse("repeat 900\n" + lets + "\nend\n");
    refuse("map cell=1\n" + repeated("#", 4000) + "\n" + repeated("#\n", 400'000) + "end\n");
    refuse("bins at=0,0 count=90000 width=1 depth=1 open\n" +
           repeated("expect mean(bins) 1 within 1\n", 30'000));
    refuse("bins at=0,0 count=90000 width=1 depth=1 open\n" +
           repeated("show histogram of=bins against=uniform\n", 20'000));
    refuse("use overlap\nrepeat 999\nfill count=1000 box=0,0,10,10\nend\n");
}

// Regression: after a fill that failed, each of 998 more was tried, for 24 seconds.
TEST_CASE("after a fill that does not fit none is tried") {
    const auto fills = [](int count) {
        return load_lines("repeat " + std::to_string(count) +
                          "\nfill count=1000 box=0,0,130,130\nend\n");
    };
    check_refused(fills(10), "the box has room for only");
    check_refused(fills(999), "the box has room for only");
    CHECK(fills(999).operations < 2 * fills(10).operations);
}

// Regression: 235 MB, since all that a level has was made before its balls were compared.
TEST_CASE("of a crowd of stated balls that overlap, the first overlap is reported, and no more") {
    const auto crowd = [](const std::string& r, const std::string& more) {
        std::string text = "kind k r=" + r + "\nmap cell=1 kind=k\n";
        for (int row = 0; row < 330; ++row)
            text += std::string(330, 'o') + '\n';
        return load_lines(text + "end\n" + more);
    };
    CHECK(crowd("0.49", "").scene);
    const LoadResult overlap = crowd("0.51", "");
    check_refused(overlap, "the ball starts inside the ball");
    CHECK(overlap.diagnostics.size() == 1);
    CHECK(crowd("0.51", "use overlap\n").scene);
    // Balls of very different sizes.
    check_refused(crowd("0.49", "ball at=165,165 r=100\n"), "the ball starts inside the ball");
    check_refused(crowd("0.49", "ball at=165.5,165.4 r=0.001\n"),
                  "the ball starts inside the ball");
}

// Regression: a million balls were placed, in 2 seconds and 220 MB, before such an error was found.
TEST_CASE("what can be refused without the balls of a fill is refused before they are placed") {
    const std::string fill = "fill count=999998 box=0,0,3300,3300 r=1\n";
    const LoadResult name = load_lines(fill + "expect q.x 1 within 1\n");
    check_refused(name, "there is no ball 'q'");
    CHECK(name.operations < 100'000);
    const LoadResult overlap = load_lines("ball at=-20,0\nball at=-20.5,0\n" + fill);
    check_refused(overlap, "the ball starts inside the ball");
    CHECK(overlap.operations < 100'000);
    // Names of statements that follow the fill are known all the same.
    CHECK(load_lines("fill count=150000 box=0,0,3300,3300 r=1\nball a at=-20,0\n"
                     "expect a.x 1 within 1\n")
              .scene);
}

// Regression: a file of 3.9 MB of junk took 7 seconds, to describe 400,000 mistakes of which 20 are
// shown.
TEST_CASE("loading stops at 200 mistakes") {
    std::string junk;
    std::string unknown;
    for (int i = 0; i < 1000; ++i) {
        junk += "word" + std::to_string(i) + "\n";
        unknown += "expect word" + std::to_string(i) + ".x 1 within 1\n";
    }
    for (const std::string& lines : {junk, unknown, repeated("use grvity\n", 1000)}) {
        const LoadResult result = load_lines(lines);
        CHECK(result.diagnostics.size() == max_diagnostics);
        CHECK(result.diagnostics.front().line == 2);
    }
    Reporter reporter;
    const SourceText source{.name = "a.level", .text = {}, .lines = {}, .included_from = {}};
    int reported = 0;
    const auto report_all = [&] {
        for (; reported < 1000; ++reported)
            reporter.error("unknown-name", {&source, reported + 1, 1, 1}, "");
    };
    CHECK_THROWS_AS(report_all(), LoadStopped);
    CHECK(reported == max_errors - 1);
}

// Regression: every map copied all legends.
TEST_CASE("the work of a map does not grow with the number of legends") {
    const auto load = [](int legends) {
        std::string lines;
        for (int i = 0; i < legends; ++i) {
            lines += "legend ball ";
            append_utf8(lines, static_cast<char32_t>(0x4e00 + i));
            lines += "\n";
        }
        return load_lines(lines + "repeat 1000 step=2,0\nmap cell=1\no\nend\nend\n");
    };
    REQUIRE(load(10'000).scene);
    CHECK(load(10'000).scene->world.balls().size() == 1000);
}

TEST_CASE("there are at most 100,000 zones and devices") {
    check_refused(load_lines("bins at=0,0 count=100001 width=1 depth=1 open\n"), "zones and bins");
    check_refused(load_lines("repeat 200000\npocket at=0,0 r=1\nend\n"), "zones and bins");
    check_refused(load_lines("repeat 200000\nlamp l at=0,0\nend\n"), "devices");
}

// Regression: the expression kept the address of a flag of the finished block.
TEST_CASE("the radius of a fill may use the variable of a repeat") {
    const Scene scene = load_clean(
        "repeat 2 i step=100,0\n fill count=3 box=100*i,0,100*i+50,50 m=1..2 r=m+i\nend\n");
    CHECK(scene.world.balls().size() == 6);
}

TEST_CASE("a thousand kinds with a collide statement for each pair load") {
    std::string kinds;
    for (int i = 0; i < 1000; ++i)
        kinds += "kind k" + std::to_string(i) + "\n";
    CHECK(load_lines(kinds + "ball at=0,0\n" + repeated("collide ball ball\n", 50'000)).scene);
    const LoadResult unknown =
        load_lines(kinds + repeated("ball at=0,0 kind=kindly_unknown\n", 100'000));
    CHECK_FALSE(unknown.scene);
    CHECK(unknown.diagnostics.size() == 20);
}
