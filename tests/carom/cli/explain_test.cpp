#include <doctest/doctest.h>

#include <string>

#include "carom/support/process.h"
#include "level/statements/action_shapes.h"
#include "level/statements/rule_events.h"

using namespace carom;
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

TEST_CASE("explain lists the events, filters and actions of rules, and their numbers") {
    const std::string on = run_carom({"explain", "on"}).out;
    CHECK(on.starts_with("on NAME EVENT "));
    for (const EventWord& event : event_words())
        CHECK(has(on, std::string(event.form)));
    for (const ActionShape& action : action_shapes())
        CHECK(has(on, std::string(action.sample)));
    CHECK(has(on, "    shot judged                the rules of shot ends have run"));
    CHECK(has(on, "    once                       for the first time in a shot"));
    CHECK(has(on, "    VARIABLE +1 "));
    const std::string condition = run_carom({"explain", "if"}).out;
    for (const RuleQuantityRow& row : rule_quantities())
        CHECK(has(condition, std::string(row.name)));
    CHECK(has(condition, "    count(BALLS,ZONE)          how many of them lie in a zone"));
    CHECK(has(run_carom({"explain", "expect"}).out, "    momentum_x                 of all balls"));
    CHECK(has(run_carom({"explain", "respot"}).out, "    respot BALLS ZONE  "));
    const std::string gate = run_carom({"explain", "ball"}).out;
    CHECK(gate.starts_with("ball [NAME] at=X,Y"));
    CHECK(has(gate, "in rules (on, task, goal):\n    ball   "));
    for (std::size_t from = 0, end = 0; from < condition.size(); from = end + 1) {
        end = condition.find('\n', from);
        CAPTURE(condition.substr(from, end - from));
        CHECK(end - from <= 100);
    }
}

TEST_CASE("explain suggests a statement for a mistyped one") {
    const Finished mistyped = run_carom({"explain", "bumpr"});
    CHECK(mistyped.exit_code == 2);
    CHECK(has(mistyped.err, "there is no statement 'bumpr'; did you mean 'bumper'?"));
    CHECK(has(run_carom({"explain", "xyzzy"}).err,
              "there is no statement 'xyzzy'; `carom explain` prints them all"));
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
