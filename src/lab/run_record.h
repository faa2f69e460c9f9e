#pragma once

#include <cstdint>

#include "lab/escape.h"
#include "level/scene.h"
#include "physics/solver.h"
#include "physics/totals.h"

namespace carom {

/// What is noticed on the way of a run, for its report.
struct RunRecord {
    SolverSettings solver;
    Totals totals_start;
    double max_overlap = 0.0;  ///< deepest at the end of any tick, a length
    EscapeWatch escape;
    std::uint64_t ball_ticks = 0;  ///< balls that there were, summed over the ticks
};

RunRecord begin_record(const Scene& scene, const SolverSettings& solver);

/// Pre: called after every tick of `world`.
void note_tick(RunRecord& record, const World& world);

/// The solver that a scene runs under when nobody says otherwise: its own, else what carom picks.
SolverSettings solver_for(const Scene& scene);

}  // namespace carom
