#include <doctest/doctest.h>

#include "carom/support/process.h"

using namespace carom::test;

TEST_CASE("explain prints a statement with its keys, and what begins with a word") {
    const Finished peg = run_carom({"explain", "peg"});
    CHECK(peg.exit_code == 0);
    CHECK(peg.out.starts_with("peg "));
    CHECK(has(peg.out, "r=         a length, 0 or more; required"));
    CHECK_FALSE(has(peg.out, "pegs"));
    const Finished use = run_carom({"explain", "use"});
    CHECK(has(use.out, "use gravity "));
    CHECK(has(use.out, "use drag "));
    CHECK(run_carom({"explain", "use", "drag"}).out.starts_with("use drag "));
    CHECK(has(run_carom({"explain"}).out, "use gravity "));
}

TEST_CASE("explain suggests a statement for a mistyped one") {
    const Finished mistyped = run_carom({"explain", "bumpr"});
    CHECK(mistyped.exit_code == 2);
    CHECK(has(mistyped.err, "there is no statement 'bumpr'; did you mean 'bumper'?"));
}

TEST_CASE("new writes a level that loads, copies another, and leaves what is there") {
    const TemporaryFolder folder;
    const std::string file = folder.path("mine.level");
    CHECK(run_carom({"new", file}).exit_code == 0);
    CHECK(run_carom({"check", file}).exit_code == 0);
    const std::string text = content(file);
    CHECK(has(run_carom({"new", file, "--template", "gas"}).err, "exists already"));
    CHECK(content(file) == text);
    const std::string copy = folder.path("copy.level");
    CHECK(run_carom({"new", copy, "--template", file}).exit_code == 0);
    CHECK(content(copy) == text);
    CHECK(has(run_carom({"new", folder.path("a"), "--template", "none"}).err, "no level 'none'"));
}

TEST_CASE("check reads a level from standard input") {
    const Finished empty = run_carom({"check", "-"});
    CHECK(empty.exit_code == 2);
    CHECK(has(empty.err, "standard input:1:1: error: "));
}

TEST_CASE("help fits in 80 columns") {
    for (const char* command : {"play", "run", "picture", "compare"}) {
        const std::string help = run_carom({command, "--help"}).out;
        for (std::size_t from = 0; from < help.size();) {
            const std::size_t end = help.find('\n', from);
            CAPTURE(help.substr(from, end - from));
            CHECK(end - from <= 80);
            from = end + 1;
        }
    }
}
