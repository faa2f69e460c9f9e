#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "carom/support/process.h"

// `carom run --check` as a program. tests/lab/run/invariants_test.cpp has a fault for each
// invariant.

using namespace carom;
using namespace carom::test;

namespace {

// Both balls are struck at tick 5, side by side. Far out, numbers lie further apart than the balls
// are wide: in tick 8 they come to lie in one place.
struct Folder : TemporaryFolder {
    std::string level = file("far.level",
                             "carom 1 \"Far\"\n"
                             "rate 60\n"
                             "world 0,0 20,10\n"
                             "ball at=0,5 r=1\n"
                             "ball at=2.5,5 r=1\n");
    std::string far = file("far.txt", "at 5 strike 0 1e18,0\nat 5 strike 1 1e18,0\n");
    std::string near = file("near.txt", "at 5 strike 0 1,0\n");

    Finished run(const std::string& commands, bool is_checked) const {
        std::vector<std::string> words{"run",   level,     "--commands", commands,   "--solver",
                                       "swept", "--ticks", "200",        "--report", "-"};
        if (is_checked) words.push_back("--check");
        return run_carom(words);
    }
};

}  // namespace

TEST_CASE("run --check ends with exit code 1 after the first tick that breaks an invariant") {
    const Folder folder;
    const Finished broken = folder.run(folder.far, true);
    CHECK(broken.exit_code == 1);
    CHECK(has(broken.err, "overlap is broken in tick 8 (0.133333 s), ball 0, ball 1: by 2"));
    CHECK(has(broken.out, "\"ticks\": 8"));
}

TEST_CASE("run --check goes to the end where nothing is broken, and so does a run without it") {
    const Folder folder;
    const Finished sound = folder.run(folder.near, true);
    CHECK(sound.exit_code == 0);
    CHECK(sound.err.empty());
    CHECK(has(sound.out, "\"ticks\": 200"));
    const Finished unchecked = folder.run(folder.far, false);
    CHECK(unchecked.exit_code == 0);
    CHECK(has(unchecked.out, "\"ticks\": 200"));
}
