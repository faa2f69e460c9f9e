#include "lab/run_record.h"

#include <algorithm>

namespace carom {

RunRecord begin_record(const Scene& scene, const SolverSettings& solver) {
    return {.solver = solver,
            .totals_start = totals(scene.world),
            .max_overlap = 0.0,
            .escape = EscapeWatch(scene),
            .ball_ticks = 0};
}

void note_tick(RunRecord& record, const World& world) {
    record.max_overlap = std::max(record.max_overlap, deepest_overlap(world));
    record.escape.note_births(world);
    record.ball_ticks += world.balls.size();
}

SolverSettings solver_for(const Scene& scene) {
    return scene.solver ? *scene.solver : pick_solver(scene.world).settings;
}

}  // namespace carom
