#pragma once

#include <doctest/doctest.h>

#include "physics/solver.h"
#include "physics/world/fingerprint.h"

namespace carom {

/// Cancels a tick of `world` at its first poll, at later and later ones, and lets it end at last.
/// Requires that a cancelled tick leaves the world as it was, calls `check()` after each, and
/// checks that the whole tick gives the same bits as one that was never cancelled.
template <typename Check>
void cancel_at_each_poll(World& world, Solver& solver, Check&& check) {
    const World start = world;
    // Every poll at first, then more and more of them apart: there are thousands.
    int cancelled_after = 0;
    for (;; cancelled_after += 1 + cancelled_after / 8) {
        int asked = 0;
        const auto outcome = solver.tick(world, [&] { return asked++ < cancelled_after; });
        if (outcome != TickOutcome::cancelled) break;
        REQUIRE(fingerprint(world) == fingerprint(start));
        check();
    }
    CHECK(cancelled_after > 2);
    World straight = start;
    Solver(solver.settings()).tick(straight);
    CHECK(fingerprint(world) == fingerprint(straight));
    CHECK(world.ledger().ball_ball_collisions == straight.ledger().ball_ball_collisions);
}

}  // namespace carom
