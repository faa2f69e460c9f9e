#include <doctest/doctest.h>

#include <string>

#include "lab/support/fuzzed_scene.h"
#include "physics/solver.h"

// Random scenes keep what every tick must keep, under every solver. scripts/check-scenes runs as
// many of them as one likes.

using namespace carom;
using namespace carom::test;

namespace {

void check_scene(std::uint64_t number) {
    const FuzzedScene fuzzed = fuzzed_scene(number);
    if (!fuzzed.scene) return;
    for (const SolverKind kind : solvers_available()) {
        if (!supports(kind, fuzzed.scene->world.model())) continue;
        const CheckedRun run = check_run(fuzzed, kind);
        CAPTURE(number);
        CAPTURE(std::string(name(kind)));
        if (run.breach) FAIL_CHECK(text(*run.breach, fuzzed.scene->world.rate()));
    }
}

}  // namespace

TEST_CASE("fuzzed scenes keep the invariants") {
    for (std::uint64_t number = 1; number <= 100; ++number)
        check_scene(number);
}

// Each of these once broke an invariant.
TEST_CASE("fuzzed scenes that have broken an invariant no longer do") {
    for (const std::uint64_t number :
         {123,  199,  274,  339,  371,  454,  472,  500,  519,  561,  578,  645,  689,  926, 1290,
          1358, 1637, 1793, 1818, 3153, 3265, 3457, 4442, 5170, 5266, 7662, 8228, 8458, 8961})
        check_scene(number);
}

TEST_SUITE("long") {
    TEST_CASE("700 fuzzed scenes keep the invariants") {
        for (std::uint64_t number = 1; number <= 700; ++number)
            check_scene(number);
    }
}
