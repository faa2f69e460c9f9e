#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lab/json.h"
#include "level/scene/scene.h"
#include "physics/solver.h"

/// What can be chosen between: solvers with their settings, and rates of ticks.
namespace carom {

/// One way to simulate a level.
struct Choice {
    SolverSettings solver;
    double rate = 120.0;  ///< ticks a second

    friend bool operator==(const Choice&, const Choice&) = default;
};

/// {"updates": 4, "steps": 15}: the settings that the solver has, as an object.
void write_settings(JsonWriter& json, const SolverSettings& solver);

/// What `carom measure` tries: every solver of `kinds` at every one of `rates`; at the level's own
/// rate also with other numbers of updates and substeps; and what the level itself runs under,
/// which comes first. Nothing stands there twice.
std::vector<Choice> choices_for(const Scene& scene, std::span<const SolverKind> kinds,
                                std::span<const double> rates);

/// The rates that are tried where nobody names others: a quarter, half, once, twice and four times
/// the level's own.
std::vector<double> usual_rates(double own);

/// The greatest rate of which all are whole multiples, to within rounding: at its instants, all of
/// them have just ended a tick. Pre: rates > 0, at least one.
double common_rate(std::span<const double> rates);

/// Ticks of `rate` in one of `common`. Pre: `common` comes from common_rate.
std::uint64_t ticks_each(double rate, double common);

/// What solvers are measured against, and what says how far it can be believed: the check is as
/// good a solver that rounds, or cuts time, differently. Where the two part, chaos has grown their
/// last digits into something that can be seen, and nobody knows the truth any more.
struct Reference {
    Choice truth;
    Choice check;
};
/// `event` in about 32 digits, checked by `event` in doubles, both at the level's rate: what a tick
/// is for (births, sinks, stops) then happens as the level says.
Reference reference_settings(double rate);

}  // namespace carom
