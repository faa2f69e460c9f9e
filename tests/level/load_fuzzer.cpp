#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "level/load.h"
#include "physics/solver.h"
#include "physics/world/fingerprint.h"

/// Loads bytes from libFuzzer as a level, and runs a level that loads and is small for a few ticks.
/// The corpus is the shipped and the broken levels. With clang++:
///
///     cmake -B build/fuzz -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=RelWithDebInfo
///     \
///         -DCAROM_SANITIZE=address,undefined,fuzzer-no-link
///     ninja -C build/fuzz fuzz_level
///     mkdir -p build/fuzz/found
///     build/fuzz/tests/fuzz_level -max_total_time=600 -timeout=20 -max_len=2000 \
///         build/fuzz/found levels tests/level/broken
namespace {

void check(bool holds) {
    if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace carom;
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    const LoadResult result = load_level(text, "fuzz.level");
    check(result.diagnostics.size() <= 20);
    bool has_error = false;
    for (const Diagnostic& d : result.diagnostics) {
        has_error = has_error || d.severity == Severity::error;
        check(d.line >= 1 && d.column >= 1 && d.length >= 1 && !render(d).empty());
    }
    check(result.scene.has_value() != has_error);
    if (!result.scene || result.scene->world.balls().size() > 50 ||
        result.scene->world.capsules().size() > 200 || result.scene->world.emitters().size() > 10) {
        return 0;
    }
    for (const SolverKind kind : {SolverKind::discrete, SolverKind::substep, SolverKind::swept}) {
        World world = result.scene->world;
        Solver solver({.kind = kind});
        for (int tick = 0; tick < 5; ++tick)
            solver.tick(world);
        fingerprint(world);
    }
    return 0;
}
