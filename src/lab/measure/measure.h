#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "game/commands/command.h"
#include "lab/hooks.h"
#include "lab/measure/contact_order.h"
#include "lab/measure/independent.h"
#include "lab/measure/pareto.h"
#include "lab/run/choice.h"
#include "lab/run/figures.h"
#include "level/scene/scene.h"

/// Cost against error: every solver at a range of rates, measured against the reference. All
/// results but the costs, and the choices based on them, depend on the level and the settings
/// alone.
///
/// Errors, differences and overlaps are in ball radii (Measurement::radius is one), so that levels
/// can be compared; times are in simulated seconds.
namespace carom {

struct MeasureSettings {
    double time = 2.0;  ///< s simulated by every choice, > 0
    int repeats = 3;    ///< runs of each choice to measure its cost, >= 1, besides the one that
                        ///< measures everything else
    double tolerance = 1e-3;             ///< radii, > 0: an acceptable error
    std::vector<double> rates;           ///< ticks a second, each > 0; empty: the usual rates
    std::vector<SolverKind> solvers;     ///< empty: all solvers
    std::optional<double> horizon;       ///< s, > 0: when errors are compared; none: see headline
    std::vector<TimedCommand> commands;  ///< of a recording of the level: see Trial
};

/// The error of a choice at one instant.
struct ErrorAt {
    double rms = 0.0;  ///< of the positions, radii; infinite if a position is not finite
    double max = 0.0;  ///< of the ball with the largest error
    /// Balls that only one of the two runs has; they are left out of the errors.
    std::size_t unpaired = 0;
    OrderFaults contacts;  ///< in the contacts up to that instant
};

/// The cost of a run in seconds of the hooks' clock: the mean of all runs, and the best one.
struct Cost {
    double whole = 0.0;
    double best = 0.0;
};

struct Measured {
    Choice choice;
    Cost cost;
    double ball_seconds = 0.0;    ///< the number of balls, integrated over simulated time
    std::vector<ErrorAt> errors;  ///< by Measurement::horizons
    double good_for = 0.0;        ///< s: the last horizon up to which the error is acceptable
    /// By figures(), for the whole run, lengths in radii. None if there is no value, or if `carom
    /// measure` does not have the figure.
    std::vector<std::optional<double>> figures;
    std::uint64_t stood_still = 0;  ///< ticks in which time stood still for some balls
    std::uint64_t refused = 0;      ///< commands of the recording
};

struct Measurement {
    double rate = 120.0;  ///< the level's, ticks a second
    std::uint64_t seed = 0;
    std::size_t balls = 0;  ///< at the start
    double radius = 1.0;    ///< mean, a length of the level
    double time = 0.0;
    int repeats = 1;
    double tolerance = 0.0;
    Choice own;  ///< the level's own solver and rate
    Reference reference;
    /// The instants at which errors are measured: 1, 2, 3, 4, 6, 8, 12, ... times the period of the
    /// lowest common rate, as long as the reference can be trusted.
    std::vector<double> horizons;
    std::vector<double> doubts;  ///< by horizon: RMS difference of the two reference runs, radii
    /// When the two reference runs, or the independent check, differed by more than the tolerance;
    /// none: they never did.
    std::optional<double> chaos;
    IndependentCheck independent;  ///< differences in radii
    /// Index of the horizon at which choices are compared: the last one at which three quarters of
    /// the choices have an error below one radius, or the last one up to MeasureSettings::horizon.
    /// None if the references diverge at once: then faults other than the error decide.
    std::optional<std::size_t> headline;
    std::vector<Measured> rows;  ///< by choices_for
};

/// None if `hooks.go_on` returned false before the reference was known. If it does so later, `rows`
/// has the choices that were complete by then. Pre: the settings are in range.
std::optional<Measurement> measure(const Scene& scene, const MeasureSettings& settings,
                                   const LabHooks& hooks);

/// The figure with that key (figures.h) of a row; none if it has no value. Pre: `carom measure` has
/// it.
std::optional<double> figure_of(const Measured& row, std::string_view key);

/// A cost of `row` in seconds, converted to nanoseconds per ball and simulated second; none without
/// balls.
std::optional<double> ns_per_ball_second(const Measured& row, double seconds);

/// Seconds, in the best run, for one tick of the level (1/rate simulated seconds),
/// whatever the rate of the choice.
double seconds_per_level_tick(const Measurement& measurement, const Measured& row);

/// The error at the headline horizon. Pre: there is one.
double headline_error(const Measurement& measurement, const Measured& row);

/// The rows as pairs of cost (seconds per tick of the level, best run) and worst fault (faults.h).
std::vector<Tradeoff> tradeoffs(const Measurement& measurement);

}  // namespace carom
