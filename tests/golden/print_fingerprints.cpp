#include <fmt/format.h>

#include "golden/golden.h"

// carom-fingerprints LEVELS REPLAYS [NAME]...: prints the contents of tests/golden/fingerprints.txt
// for the levels and the recordings of two folders. scripts/determinism builds it with many
// compilers, options and machines.
int main(int count, char** arguments) {
    using namespace carom::test;
    if (count < 3) {
        fmt::print(stderr, "usage: carom-fingerprints LEVELS REPLAYS [NAME]...\n");
        return 2;
    }
    for (const GoldenRun& run : golden_levels(arguments[1], {arguments + 3, arguments + count}))
        fmt::print("{}\n", run.line);
    for (const GoldenRun& run : golden_replays(arguments[2]))
        fmt::print("{}\n", run.line);
    return 0;
}
