#include <doctest/doctest.h>

#include "physics/solver.h"
#include "physics/support/scenes.h"
#include "physics/world/fingerprint.h"

// Under `event`, a ball that passed a one-way edge from behind met it again in the continuing run,
// but not in a run from a snapshot: different bits from one state.

using namespace carom;

TEST_CASE("one-way edges: a snapshot continues with the same bits in every solver") {
    for (const SolverKind kind : solvers_available()) {
        CAPTURE(name(kind));
        World whole = scenes::gas(60, 7);
        add_capsule(whole, {{12.5, -1.0}, {13.5, 26.0}, 0.0}, 0, Side::left);
        add_capsule(whole, {{-1.0, 8.0}, {26.0, 8.5}, 0.1}, 0, Side::right);
        World parted = whole;
        Solver solver({.kind = kind});
        for (int tick = 0; tick < 240; ++tick) {
            solver.tick(whole);
            Solver({.kind = kind}).tick(parted);
            REQUIRE(fingerprint(whole) == fingerprint(parted));
        }
    }
}
