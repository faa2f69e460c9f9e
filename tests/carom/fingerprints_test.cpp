#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "carom/support/process.h"
#include "golden/golden.h"

// The same bits everywhere: every level that ships, under every solver, must reach the state that
// tests/golden/fingerprints.txt has for it, whatever the compiler and its options.
// `scripts/update-golden` writes that file anew, for a change that is meant to change the bits;
// `scripts/determinism` compares it with what many compilers and machines give.

using namespace carom;

namespace {

const std::string golden_file = CAROM_SOURCE_DIR "/tests/golden/fingerprints.txt";

std::vector<std::string> golden_lines() {
    std::vector<std::string> lines;
    std::istringstream text(test::content(golden_file));
    for (std::string line; std::getline(text, line);)
        lines.push_back(line);
    return lines;
}

}  // namespace

TEST_CASE("golden fingerprints of every level under every solver") {
    std::vector<std::string> now = test::fingerprint_lines(CAROM_SOURCE_DIR "/levels");
    for (const std::string& line : test::replay_lines(CAROM_SOURCE_DIR "/tests/golden"))
        now.push_back(line);
    if (std::getenv("CAROM_UPDATE_GOLDEN") != nullptr) {
        std::ofstream file(golden_file);
        for (const std::string& line : now)
            file << line << '\n';
        return;
    }
    const std::vector<std::string> golden = golden_lines();
    for (const std::string& line : now) {
        INFO("not among the golden lines: ", line);
        CHECK(std::ranges::find(golden, line) != golden.end());
    }
    for (const std::string& line : golden) {
        INFO("golden, but not reached: ", line);
        CHECK(std::ranges::find(now, line) != now.end());
    }
}
