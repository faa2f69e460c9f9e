#include <fmt/format.h>

#include "golden/golden.h"

// carom-fingerprints FOLDER [NAME]...: prints what tests/golden/fingerprints.txt holds for the
// levels of a folder. scripts/determinism builds it with many compilers, options and machines.
int main(int count, char** arguments) {
    if (count < 2) {
        fmt::print(stderr, "usage: carom-fingerprints FOLDER [NAME]...\n");
        return 2;
    }
    for (const std::string& line :
         carom::test::fingerprint_lines(arguments[1], {arguments + 2, arguments + count}))
        fmt::print("{}\n", line);
    return 0;
}
