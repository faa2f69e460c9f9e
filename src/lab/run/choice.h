#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lab/json.h"
#include "level/scene/scene.h"
#include "physics/solver.h"

/// A choice: a solver with its settings, and a tick rate.
namespace carom {

/// One way to simulate a level.
struct Choice {
    SolverSettings solver;
    double rate = 120.0;  ///< ticks a second

    friend bool operator==(const Choice&, const Choice&) = default;
};

/// {"updates": 4, "steps": 15}: the settings that the solver uses, as an object.
void write_settings(JsonWriter& json, const SolverSettings& solver);

/// The choices that `carom measure` tries: every solver of `kinds` at every one of `rates`, and at
/// the level's own rate also other numbers of updates and substeps. The level's own choice comes
/// first. No choice occurs twice.
std::vector<Choice> choices_for(const Scene& scene, std::span<const SolverKind> kinds,
                                std::span<const double> rates);

/// The default rates to try: a quarter, half, once, twice and four times the level's own.
std::vector<double> usual_rates(double own);

/// The greatest rate of which all `rates` are whole multiples, within rounding: at its instants all
/// have just completed a tick. Pre: rates > 0, at least one.
double common_rate(std::span<const double> rates);

/// The number of ticks at `rate` in one period of `common`. Pre: `common` comes from common_rate.
std::uint64_t ticks_each(double rate, double common);

/// The solver that others are measured against, and a check of how far it can be trusted. The check
/// is an equally accurate solver with different rounding. Where the two diverge, chaos has
/// amplified their rounding, and the truth is unknown from there on.
struct Reference {
    Choice truth;
    Choice check;
};
/// `event` in about 32 digits, checked by `event` in doubles, both at the level's rate, so that
/// emitters, sinks and stops act at the level's ticks.
Reference reference_settings(double rate);

}  // namespace carom
