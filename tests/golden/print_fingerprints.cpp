#include <fmt/format.h>

#include "golden/golden.h"

// carom-fingerprints LEVELS REPLAYS [NAME]...: prints what tests/golden/fingerprints.txt holds for
// the levels and the recordings of two folders. scripts/determinism builds it with many compilers,
// options and machines.
int main(int count, char** arguments) {
    using namespace carom::test;
    if (count < 3) {
        fmt::print(stderr, "usage: carom-fingerprints LEVELS REPLAYS [NAME]...\n");
        return 2;
    }
    for (const std::string& line :
         fingerprint_lines(arguments[1], {arguments + 3, arguments + count}))
        fmt::print("{}\n", line);
    for (const std::string& line : replay_lines(arguments[2]))
        fmt::print("{}\n", line);
    return 0;
}
