#include <algorithm>

#include "fuzz/fuzzer.h"
#include "level/load.h"
#include "physics/solver.h"
#include "physics/world/fingerprint.h"

// Levels: they load or are refused with messages, and those that load and are small are simulated
// for a few ticks under every solver. The corpus is the levels that ship and the broken ones.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace carom;
    const LoadResult result = load_level(fuzz::text_of(bytes, size), "fuzz.level");
    fuzz::check(result.diagnostics.size() <= 20);
    bool has_error = false;
    for (const Diagnostic& d : result.diagnostics) {
        has_error = has_error || d.severity == Severity::error;
        fuzz::check(d.line >= 1 && d.column >= 1 && d.length >= 1 && !render(d).empty());
    }
    fuzz::check(result.scene.has_value() != has_error);
    if (!result.scene || !fuzz::is_small(result.scene->world)) return 0;
    for (const SolverKind kind : solvers_available()) {
        World world = result.scene->world;
        if (!supports(kind, world.model())) continue;
        Solver solver({.kind = kind});
        const auto keep_going = fuzz::work_budget();
        for (int tick = 0; tick < 5; ++tick)
            if (solver.tick(world, keep_going) == TickOutcome::cancelled) break;
        fingerprint(world);
    }
    return 0;
}
