#include "physics/solver.h"

namespace carom {

// What each solver promises is in docs/accuracy.md, and measured there. Free paths that are
// straight lines are where `event` is both exact and the cheaper one; heaps are what `swept` pays
// for: many balls that lose energy under gravity and are not drained.
SolverPick pick_solver(const World& world) {
    if (world.model().cloth)
        return {{.kind = SolverKind::event},
                "exact from impact to impact, sliding, rolling and coming to rest on cloth"};
    if (!world.model().gravity && !world.model().drag)
        return {{.kind = SolverKind::event},
                "exact from impact to impact, and cheapest where nothing bends the paths"};
    constexpr std::size_t many = 400;
    std::size_t balls = world.balls().size();
    for (const Emitter& emitter : world.emitters())
        balls += emitter.count - emitter.emitted;
    bool drains = false;
    for (const Zone& zone : world.zones())
        drains = drains || zone.effect == Zone::Effect::sink;
    const bool heaps =
        world.model().gravity && world.model().lossy && world.model().ball_ball && !drains;
    if (heaps && balls > many)
        return {{.kind = SolverKind::contact}, "many balls come to rest on one another"};
    return {{.kind = SolverKind::swept},
            "nothing passes through anything, and free flight is exact"};
}

}  // namespace carom
