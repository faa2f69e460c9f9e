#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "carom/level_files.h"
#include "carom/support/process.h"
#include "physics/fingerprint.h"
#include "physics/solver.h"

// The same bits everywhere: every level that ships, under every solver, must reach the state that
// tests/golden/fingerprints.txt has for it, whatever the compiler and its options.
// `scripts/update-golden` writes that file anew, for a change that is meant to change the bits.

using namespace carom;

namespace {

const std::string golden_file = CAROM_SOURCE_DIR "/tests/golden/fingerprints.txt";

// Ten balls take a tick in no time; thousands would take minutes in a build for debugging.
std::uint64_t ticks_for(const World& world) {
    return world.balls.size() > 200 ? 120 : 600;
}

// "LEVEL SOLVER TICKS FINGERPRINT"
std::string line_for(const std::string& level, const Scene& scene, SolverKind kind) {
    // A level's own settings hold for its own solver.
    SolverSettings settings{.kind = kind};
    if (scene.solver && scene.solver->kind == kind) settings = *scene.solver;
    World world = scene.world;
    Solver solver(settings);
    const std::uint64_t ticks = ticks_for(world);
    while (world.tick < ticks)
        solver.tick(world);
    return fmt::format("{} {} {} {}", level, name(kind), ticks, hexadecimal(fingerprint(world)));
}

std::vector<std::string> lines_now() {
    std::vector<std::string> lines;
    for (const LevelEntry& level : levels_in(CAROM_SOURCE_DIR "/levels")) {
        const LoadedLevel loaded = load_level_file(level.path, {});
        CAPTURE(level.path);
        REQUIRE(loaded.result.scene.has_value());
        for (const SolverKind kind : solvers_available()) {
            lines.push_back(line_for(level.name, *loaded.result.scene, kind));
        }
    }
    return lines;
}

std::vector<std::string> golden_lines() {
    std::vector<std::string> lines;
    std::istringstream text(test::content(golden_file));
    for (std::string line; std::getline(text, line);)
        lines.push_back(line);
    return lines;
}

}  // namespace

TEST_CASE("golden fingerprints of every level under every solver") {
    const std::vector<std::string> now = lines_now();
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
