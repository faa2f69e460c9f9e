#include <doctest/doctest.h>

#include <string>

#include "level/load.h"
#include "memory/counts.h"

using namespace carom;

namespace {

// A million balls, in a file of 3 kB.
std::string million_balls(const std::string& map_words, const std::string& last_lines) {
    return "carom 1 \"A test\"\nkind k r=0.5\nrepeat 1000 step=0,2\nmap cell=1 " + map_words +
           "\n" + std::string(1000, 'o') + "\nend\nend\n" + last_lines;
}

}  // namespace

// Regression: what refers to unknown names was found when all balls had been made, in 180 MB.
TEST_CASE("a million balls and unknown names cost less than 100 MB") {
    for (const char* lines : {"expect q.x 5 within 1\nexpect r.x 5 within 1\n", "collide k zz\n",
                              "show histogram zz\n", "kick zz 1,2\n"}) {
        CAPTURE(std::string(lines));
        test::memory_counts.most_bytes = test::memory_counts.bytes;
        const std::size_t before = test::memory_counts.bytes;
        const LoadResult result = load_level(million_balls("kind=k", lines), "test.level");
        CHECK_FALSE(result.scene);
        CHECK_FALSE(result.diagnostics.empty());
        CHECK(test::memory_counts.most_bytes - before < 100'000'000);
    }
}
