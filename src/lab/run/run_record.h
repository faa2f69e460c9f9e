#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lab/run/figures.h"
#include "lab/run/judge.h"
#include "level/scene/scene.h"
#include "physics/solver.h"
#include "physics/tick/totals.h"

namespace carom {

/// The ticks in which time stood still for some balls (Solver::standing).
struct StoodStill {
    std::uint64_t ticks = 0;       ///< how many
    std::uint64_t first_tick = 0;  ///< from 1
    std::size_t balls = 0;         ///< in the first of them
    std::size_t most_balls = 0;    ///< in any of them
};

/// The ticks with balls too small for what the solver promises (Promise::most_fall).
struct NotHeld {
    std::uint64_t ticks = 0;
    std::uint64_t first_tick = 0;  ///< from 1
    std::size_t most_balls = 0;    ///< in any of them
};

/// The data that a run collects for its report.
struct RunRecord {
    SolverSettings solver;
    Totals totals_start;
    RunWatch watch;
    StoodStill stood_still;
    NotHeld not_held;
    /// The level says `use modulus`, and the solver lets impacts take no time.
    bool ignores_modulus = false;
    std::uint64_t ball_ticks = 0;  ///< the number of balls, summed over the ticks
    /// By Scene::expects. A time means the tick nearest to it; no time means the end.
    std::vector<Judgement> judgements;
    /// The counts of a game, by name; noted at the end.
    std::vector<std::pair<std::string, std::int64_t>> tallies;
    /// The variables of the level's rules, by name: of each player in turn, or one value; noted at
    /// the end.
    std::vector<std::pair<std::string, std::vector<std::int64_t>>> variables;
    /// Actions of the level's rules beyond what a tick may carry out, and the tick of the first;
    /// noted at the end.
    std::uint64_t actions_left_out = 0;
    std::uint64_t first_left_out = 0;
};

/// Records the start, and judges expectations due at time 0.
RunRecord begin_record(const Scene& scene, const SolverSettings& solver);

/// Pre: called after every tick of `world`, which began as scene.world, with its contacts.
void note_tick(RunRecord& record, const Scene& scene, const World& world,
               std::span<const Contact> contacts);

/// Notes for how many balls time stood still in the tick that `world` has just completed.
void note_standing(RunRecord& record, const World& world, std::size_t balls);

/// What is noteworthy of the run, a line for each kind of note, each with "note: ". Empty if
/// nothing is.
std::string notes_text(const RunRecord& record, double rate);

/// Judges expectations due at the end. Not called for an interrupted run.
void note_end(RunRecord& record, const Scene& scene, const World& world);

/// Whether an expectation was judged and does not hold.
bool has_failure(const RunRecord& record);

/// The solver if no option names one: the level's, else the choice of pick_solver.
SolverSettings solver_for(const Scene& scene);

}  // namespace carom
