#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lab/run/figures.h"
#include "lab/run/judge.h"
#include "lab/run/notes.h"
#include "level/scene/scene.h"
#include "physics/solver.h"
#include "physics/tick/totals.h"

namespace carom {

/// A command chose other settings, or another solver, after this tick.
struct SolverChange {
    std::uint64_t tick = 0;
    SolverSettings settings;
};

/// The data that a run collects for its report.
struct RunRecord {
    SolverSettings solver;                     ///< of the first tick
    std::vector<SolverChange> solver_changes;  ///< later ones
    Totals totals_start;
    RunWatch watch;
    RunNotes notes;
    std::uint64_t ball_ticks = 0;  ///< the number of balls, summed over the ticks
    /// By Scene::expects. A time means the tick nearest to it; no time means the end.
    std::vector<Judgement> judgements;
    /// The counts of a game, by name; noted at the end.
    std::vector<std::pair<std::string, std::int64_t>> tallies;
    /// The variables of the level's rules, by name: of each player in turn, or one value; noted at
    /// the end.
    std::vector<std::pair<std::string, std::vector<std::int64_t>>> variables;
};

/// Records the start, and judges expectations due at time 0.
RunRecord begin_record(const Scene& scene, const SolverSettings& solver);

/// Pre: called after every tick of `world`, which began as scene.world, with what `solver` says of
/// it, and the rules of the game, if there are any.
void note_tick(RunRecord& record, const Scene& scene, const World& world, const Solver& solver,
               const RuleState* rules = nullptr);

/// Judges expectations due at the end. Not called for an interrupted run.
void note_end(RunRecord& record, const Scene& scene, const World& world);

/// Whether an expectation was judged and does not hold.
bool has_failure(const RunRecord& record);

/// The solver if no option names one: the level's, else the choice of pick_solver.
SolverSettings solver_for(const Scene& scene);

}  // namespace carom
