#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "carom/support/process.h"
#include "golden/golden.h"
#include "golden/trace.h"

// Bits are equal everywhere: every level that ships, under every solver, must reach the state in
// tests/golden/fingerprints.txt, whatever the compiler and its options, and its balls must follow
// tests/golden/traces.txt. `scripts/update golden` renews both files after a change that is meant
// to change the bits; `scripts/determinism` compares the fingerprints of many compilers and
// machines.

using namespace carom;

namespace {

const std::string golden_file = CAROM_SOURCE_DIR "/tests/golden/fingerprints.txt";
const std::string trace_file = CAROM_SOURCE_DIR "/tests/golden/traces.txt";

std::vector<std::string> file_lines(const std::string& file) {
    std::vector<std::string> lines;
    std::istringstream text(test::content(file));
    for (std::string line; std::getline(text, line);)
        lines.push_back(line);
    return lines;
}

/// The line of a run without its fingerprint: "LEVEL SOLVER TICKS" or "FILE TICKS".
std::string name_of(const test::GoldenRun& run) {
    return run.line.substr(0, run.line.rfind(' '));
}

/// By the name of the run. The rows of its trace are indented below it.
std::map<std::string, std::vector<std::string>> golden_traces() {
    std::map<std::string, std::vector<std::string>> traces;
    std::vector<std::string>* rows = nullptr;
    for (const std::string& line : file_lines(trace_file)) {
        if (!line.starts_with(' '))
            rows = &traces[line];
        else if (rows != nullptr)
            rows->push_back(line.substr(1));
    }
    return traces;
}

std::vector<test::GoldenRun> runs_now() {
    std::vector<test::GoldenRun> runs = test::golden_levels(CAROM_SOURCE_DIR "/levels");
    for (test::GoldenRun& run : test::golden_replays(CAROM_SOURCE_DIR "/tests/golden"))
        runs.push_back(std::move(run));
    return runs;
}

void write_golden(const std::vector<test::GoldenRun>& runs) {
    std::ofstream fingerprints(golden_file), traces(trace_file);
    for (const test::GoldenRun& run : runs) {
        fingerprints << run.line << '\n';
        traces << name_of(run) << '\n';
        for (const std::string& row : run.trace)
            traces << ' ' << row << '\n';
    }
}

}  // namespace

TEST_CASE("golden fingerprints of every level under every solver") {
    const std::vector<test::GoldenRun> now = runs_now();
    for (const test::GoldenRun& run : now) {
        INFO(run.line);
        REQUIRE_FALSE(run.has_failed);
    }
    if (std::getenv("CAROM_UPDATE_GOLDEN") != nullptr) return write_golden(now);
    const std::vector<std::string> golden = file_lines(golden_file);
    const auto traces = golden_traces();
    for (const test::GoldenRun& run : now) {
        INFO("not among the golden lines: ", run.line);
        CHECK(std::ranges::find(golden, run.line) != golden.end());
        const auto trace = traces.find(name_of(run));
        REQUIRE(trace != traces.end());
        const auto difference = test::difference(trace->second, run.trace, run.ticks);
        INFO(name_of(run), ": ", difference.value_or(""));
        CHECK_FALSE(difference.has_value());
    }
    for (const std::string& line : golden) {
        INFO("golden, but not reached: ", line);
        CHECK(std::ranges::find(now, line, &test::GoldenRun::line) != now.end());
    }
}
