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

/// The trade between cost and error, measured: every solver at a range of rates against the
/// reference. Everything but the costs, and what is chosen by them, is a function of the level and
/// the settings alone.
///
/// Errors, differences and overlaps are told in ball radii (Measurement::radius is one of them), so
/// that levels can be compared; times in simulated seconds.
namespace carom {

struct MeasureSettings {
    double time = 2.0;                ///< s simulated by every choice, > 0
    int repeats = 3;                  ///< runs of each choice, for its cost, >= 1
    double tolerance = 1e-3;          ///< radii, > 0: an error that can be lived with
    std::vector<double> rates;        ///< ticks a second, each > 0; empty: the usual ones
    std::vector<SolverKind> solvers;  ///< empty: all that there are
    std::optional<double> horizon;    ///< s, > 0: when errors are compared; none: see headline
};

/// How far a choice is off at one instant.
struct ErrorAt {
    double rms = 0.0;          ///< of the positions, radii; infinite where one is not finite
    double max = 0.0;          ///< of the ball that is farthest off
    std::size_t unpaired = 0;  ///< balls that only one of the two has; they are in no error
    OrderFaults contacts;      ///< of all contacts up to then
};

/// What it takes to simulate, in seconds of the clock a run. Whole: the mean of all runs.
struct Cost {
    double whole = 0.0;
    double best = 0.0;
};

struct Measured {
    Choice choice;
    Cost cost;
    double ball_seconds = 0.0;    ///< balls that there were, each times how long it was there
    std::vector<ErrorAt> errors;  ///< by Measurement::horizons
    double good_for = 0.0;        ///< s: the last horizon up to which the error is tolerated
    /// By figures(), of the whole run, lengths in radii; none also where `carom measure` does not
    /// have the figure.
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
    /// Where errors are told: 1, 2, 3, 4, 6, 8, 12 ... times the period of the slowest common rate,
    /// as long as the reference can be believed.
    std::vector<double> horizons;
    std::vector<double> doubts;  ///< by horizon: RMS difference of the two references, radii
    /// When the two had parted by more than the tolerance; none: not within the time.
    std::optional<double> chaos;
    /// Index of the horizon that choices are compared at: the last at which three quarters of the
    /// choices still have something to do with the truth (an error of less than one radius), or the
    /// last that is not after MeasureSettings::horizon. None when the reference parts at once.
    std::optional<std::size_t> headline;
    std::vector<Measured> rows;  ///< by choices_for
};

/// None when `hooks.go_on` said no before the reference was known; when it said no later, `rows`
/// has what was complete by then. Pre: settings are in range, and every solver of theirs is there.
std::optional<Measurement> measure(const Scene& scene, const MeasureSettings& settings,
                                   const LabHooks& hooks);

/// The figure with that key (figures.h) of a row. Pre: `carom measure` has it.
std::optional<double> figure_of(const Measured& row, std::string_view key);

/// Nanoseconds of the clock for a ball and a simulated second, of a cost in seconds of `row`; none
/// where there was no ball.
std::optional<double> ns_per_ball_second(const Measured& row, double seconds);

/// Seconds of the clock for a tick of the level (1/rate simulated seconds), in its best run:
/// whatever rate the choice itself runs at.
double seconds_per_level_tick(const Measurement& measurement, const Measured& row);

/// The error at the headline's horizon. Pre: there is one.
double headline_error(const Measurement& measurement, const Measured& row);

/// The rows as pairs of cost (seconds a tick of the level, best run) and error at the headline's
/// horizon. An error below the doubt of the reference counts as the doubt: nobody can tell which of
/// two such is less. Without a headline, all errors are infinite.
std::vector<Tradeoff> tradeoffs(const Measurement& measurement);

}  // namespace carom
