#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lab/run/run_record.h"
#include "level/scene/scene.h"

/// Reports of a run, for programs and for people.
namespace carom {

/// The report of `carom run`, one JSON object (docs/command-line.md lists its keys). Everything
/// except `cost` depends on the level, the seed, the solver and the number of ticks alone. `level`:
/// the level's name as the user gave it; `seconds`: wall-clock time spent in the solver.
std::string report_json(std::string_view level, const Scene& scene, const World& world,
                        const RunRecord& record, double seconds);

/// A summary in a few lines.
std::string summary(const Scene& scene, const World& world, const RunRecord& record,
                    double seconds);

/// A line for each expectation with that verdict: "FILE:LINE: error: expect x 3 within 0: it is
/// 2.5", or "holds", or "not judged" and why.
std::string verdicts(const Scene& scene, const RunRecord& record, Verdict verdict);

/// The output of `--explain`: the terms of the model in force, and the solver with the reason for
/// it.
std::string explanation(const Scene& scene);
/// The explanation for a game. `pick`: the choice of `auto`; `asked_for`: the level's or the
/// player's choice instead.
std::string explanation(const Model& model, double rate, const SolverPick& pick,
                        const std::optional<SolverSettings>& asked_for);

}  // namespace carom
