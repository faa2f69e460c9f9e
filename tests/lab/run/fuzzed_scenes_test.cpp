#include <doctest/doctest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "bits/level_writer.h"
#include "bits/recording_writer.h"
#include "lab/support/fuzzed_scene.h"
#include "physics/solver.h"
#include "support/sanitizers.h"

// Random scenes keep what every tick must keep, under every solver. scripts/check-scenes runs as
// many of them as one likes.

using namespace carom;
using namespace carom::test;

namespace {

void check_scene(const FuzzedScene& fuzzed, const std::string& number) {
    for (const SolverKind kind : solvers_available()) {
        if (!supports(kind, fuzzed.scene->world.model())) continue;
        const CheckedRun run = check_run(fuzzed, kind);
        CAPTURE(number);
        CAPTURE(std::string(name(kind)));
        CHECK(run.ticks > 0);
        if (run.breach) FAIL_CHECK(text(*run.breach, fuzzed.scene->world.rate()));
    }
}

void check_scene(std::uint64_t number, double least_decade = bits::usual_least_decade) {
    const FuzzedScene fuzzed = fuzzed_scene(number, least_decade);
    if (fuzzed.scene) check_scene(fuzzed, std::to_string(number));
}

std::string text_of_file(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

}  // namespace

// Compilers evaluate the operands of + and the arguments of a function in different orders.
TEST_CASE("a number makes the same fuzzed scene with every compiler") {
    std::string all;
    for (std::uint64_t number = 1; number <= 300; ++number) {
        bits::Random random(number);
        const bits::Level level = bits::write_level(random);
        all += level.text;
        for (const bits::TimedLine& line : bits::write_commands(random, level))
            all += std::to_string(line.tick) + ' ' + line.command + '\n';
    }
    CHECK(bits::level_hash(all) == 8930789163239046511u);
}

TEST_CASE("fuzzed scenes keep the invariants") {
    for (std::uint64_t number = 1; number <= (has_sanitizers ? 30 : 100); ++number)
        check_scene(number);
}

// Balls may have radii of some roundings of their coordinates.
TEST_CASE("fuzzed scenes with grains keep the invariants") {
    for (std::uint64_t number = 180; number <= (has_sanitizers ? 195 : 220); ++number)
        check_scene(number, bits::grain_decade);
}

// Each of these once broke an invariant. The last line of a level is "# 109 ticks": how long it
// runs.
TEST_CASE("fuzzed scenes that have broken an invariant no longer do") {
    std::set<std::filesystem::path> paths;
    for (const auto& entry :
         std::filesystem::directory_iterator(CAROM_SOURCE_DIR "/tests/lab/scenes"))
        if (entry.path().extension() == ".level") paths.insert(entry.path());
    CHECK(paths.size() >= 52);
    std::size_t scenes = 0;
    for (std::filesystem::path path : paths) {
        if (scenes++ % 3 > 0 && has_sanitizers) continue;  // slow
        const std::string level = text_of_file(path);
        const std::uint64_t ticks = std::stoull(level.substr(level.rfind('#') + 1));
        path.replace_extension(".commands");
        const FuzzedScene fuzzed = scene_of(level, text_of_file(path), ticks);
        CAPTURE(path.stem().string());
        REQUIRE(fuzzed.scene);
        check_scene(fuzzed, path.stem().string());
    }
}

TEST_SUITE("long") {
    TEST_CASE("700 fuzzed scenes keep the invariants") {
        for (std::uint64_t number = 1; number <= 700; ++number)
            check_scene(number);
    }
}
