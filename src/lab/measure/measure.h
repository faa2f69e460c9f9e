#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "lab/hooks.h"
#include "lab/measure/contact_order.h"
#include "lab/measure/pareto.h"
#include "lab/run/choice.h"
#include "lab/run/figures.h"
#include "level/scene/scene.h"

/// Cost against error: every solver at a range of rates, measured against the reference. Everything
/// but the costs, and what is picked by them, is a function of the level and the settings alone.
///
/// Errors, differences and overlaps are in ball radii (Measurement::radius is one), so that levels
/// can be compared; times are in simulated seconds.
namespace carom {

struct MeasureSettings {
    double time = 2.0;                ///< s simulated by every choice, > 0
    int repeats = 3;                  ///< runs of each choice, for its cost, >= 1
    double tolerance = 1e-3;          ///< radii, > 0: an acceptable error
    std::vector<double> rates;        ///< ticks a second, each > 0; empty: the usual ones
    std::vector<SolverKind> solvers;  ///< empty: all that there are
    std::optional<double> horizon;    ///< s, > 0: when errors are compared; none: see headline
};

/// The error of a choice at one instant.
struct ErrorAt {
    double rms = 0.0;          ///< of the positions, radii; infinite where one is not finite
    double max = 0.0;          ///< of the ball with the largest error
    std::size_t unpaired = 0;  ///< balls that only one of the two has; no error counts them
    OrderFaults contacts;      ///< in the contacts up to then
};

/// The cost of a run in seconds of the clock: the mean of all runs, and the best one.
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
    /// By figures(), for the whole run, lengths in radii. None where there is no value, or `carom
    /// measure` does not have the figure.
    std::vector<std::optional<double>> figures;
    std::uint64_t too_dense = 0;  ///< ticks in which time stood still (TickOutcome::too_dense)
};

struct Measurement {
    double rate = 120.0;  ///< the level's, ticks a second
    std::uint64_t seed = 0;
    std::size_t balls = 0;  ///< at the start
    double radius = 1.0;    ///< mean, a length of the level
    double time = 0.0;
    int repeats = 1;
    double tolerance = 0.0;
    Choice own;  ///< what the level runs under
    Reference reference;
    /// When errors are measured: 1, 2, 3, 4, 6, 8, 12 ... times the period of the slowest common
    /// rate, as long as the reference can be trusted.
    std::vector<double> horizons;
    std::vector<double> doubts;  ///< by horizon: RMS difference of the two references, radii
    /// When the two references differed by more than the tolerance; none: not within the time.
    std::optional<double> chaos;
    /// Index of the horizon at which choices are compared: the last one at which three quarters of
    /// the choices have an error of less than a radius, or the last one that is not after
    /// MeasureSettings::horizon. None when the references diverge at once.
    std::optional<std::size_t> headline;
    std::vector<Measured> rows;  ///< by choices_for
};

/// None when `hooks.go_on` said no before the reference was known. When it says no later, `rows`
/// has the choices that were complete by then. Pre: the settings are in range.
std::optional<Measurement> measure(const Scene& scene, const MeasureSettings& settings,
                                   const LabHooks& hooks);

/// The figure with that key (figures.h) of a row. Pre: `carom measure` has it.
std::optional<double> figure_of(const Measured& row, std::string_view key);

/// A cost in seconds of `row`, as nanoseconds for a ball and a simulated second; none where there
/// was no ball.
std::optional<double> ns_per_ball_second(const Measured& row, double seconds);

/// Seconds of the clock, in the best run, for a tick of the level (1/rate simulated seconds),
/// whatever rate the choice runs at.
double seconds_per_level_tick(const Measurement& measurement, const Measured& row);

/// The error at the headline's horizon. Pre: there is one.
double headline_error(const Measurement& measurement, const Measured& row);

/// The rows as pairs of cost (seconds a tick of the level, best run) and error at the headline's
/// horizon. An error below the doubt of the reference counts as the doubt, since smaller errors
/// cannot be told apart. Without a headline, all errors are infinite.
std::vector<Tradeoff> tradeoffs(const Measurement& measurement);

}  // namespace carom
