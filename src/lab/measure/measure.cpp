#include "lab/measure/measure.h"

#include <algorithm>
#include <cmath>

#include "lab/measure/difference.h"
#include "lab/measure/faults.h"
#include "lab/measure/horizons.h"
#include "lab/measure/trial.h"
#include "lab/run/run_record.h"

namespace carom {
namespace {

// The results of the reference, for as long as it can be trusted.
struct Truth {
    std::vector<Positions> positions;  // by horizon
    std::vector<Meeting> meetings;
    std::vector<std::size_t> met;  // by horizon: the number of contacts before it
    std::vector<double> doubts;
    std::optional<double> chaos;
};

// Data shared by all runs of one measurement.
struct Bench {
    const Scene& scene;
    const MeasureSettings& settings;
    const LabHooks& hooks;
    double common = 0.0;                // rate at which all choices can be compared
    std::vector<std::uint64_t> points;  // horizons, in periods of `common`
    std::uint64_t done = 0;             // ticks
    std::uint64_t total = 0;
};

std::uint64_t ticks_of(const Bench& bench, double rate) {
    return bench.points.back() * ticks_each(rate, bench.common);
}

Trial started(const Bench& bench, const Choice& choice) {
    return {bench.scene, choice, bench.settings.commands};
}

// One tick; cancelled if the caller ended the work in it or after it.
TickOutcome tick(Bench& bench, Trial& trial) {
    const auto keep_going = [&] { return bench.hooks.go_on(bench.done, bench.total); };
    const TickOutcome outcome = trial.tick(keep_going);
    ++bench.done;
    return keep_going() ? outcome : TickOutcome::cancelled;
}

// Runs up to a horizon, or to the first tick that is not completed.
TickOutcome run_to(Bench& bench, Trial& trial, std::uint64_t point,
                   std::vector<Meeting>* meetings) {
    const std::uint64_t ticks = point * ticks_each(trial.world().rate(), bench.common);
    while (trial.world().tick() < ticks) {
        const TickOutcome outcome = tick(bench, trial);
        if (meetings != nullptr) note_meetings(*meetings, trial.contacts());
        if (outcome != TickOutcome::done) return outcome;
    }
    return TickOutcome::done;
}

std::optional<Truth> find_truth(Bench& bench, const Reference& reference, double radius) {
    Truth truth;
    Trial run = started(bench, reference.truth);
    Trial check = started(bench, reference.check);
    const World& world = run.world();
    const World& check_world = check.world();
    const std::uint64_t before = bench.done;
    for (const std::uint64_t point : bench.points) {
        const TickOutcome of_truth = run_to(bench, run, point, &truth.meetings);
        if (of_truth == TickOutcome::cancelled) return std::nullopt;
        const TickOutcome of_check = run_to(bench, check, point, nullptr);
        if (of_check == TickOutcome::cancelled) return std::nullopt;
        const bool are_done = of_truth == TickOutcome::done && of_check == TickOutcome::done;
        const double doubt = difference(world, check_world).rms / radius;
        if (!are_done || !(doubt <= bench.settings.tolerance)) {
            truth.chaos = static_cast<double>(point) / bench.common;
            break;
        }
        truth.doubts.push_back(doubt);
        truth.positions.push_back(positions_of(world));
        truth.met.push_back(truth.meetings.size());
    }
    bench.done = before + ticks_of(bench, world.rate()) + ticks_of(bench, check_world.rate());
    return truth;
}

// The oracle's differences from the truth, in radii. The truth ends where they exceed the
// tolerance.
IndependentCheck check_truth(Bench& bench, Truth& truth, double radius) {
    std::vector<double> times;
    for (std::size_t i = 0; i < truth.positions.size(); ++i)
        times.push_back(static_cast<double>(bench.points[i]) / bench.common);
    if (!bench.settings.commands.empty())
        return {.differences = {}, .ended = "it knows no commands"};
    const auto go_on = [&] { return bench.hooks.go_on(bench.done, bench.total); };
    IndependentCheck check = check_independently(bench.scene.world, times, truth.positions, go_on);
    for (std::size_t i = 0; i < check.differences.size(); ++i) {
        check.differences[i] /= radius;
        if (check.differences[i] <= bench.settings.tolerance) continue;
        truth.chaos = times[i];
        truth.positions.resize(i);
        truth.met.resize(i);
        truth.doubts.resize(i);
        check.differences.resize(i);
        check.ended = "it disagrees with the reference from there on";
    }
    return check;
}

ErrorAt error_at(const Truth& truth, std::size_t horizon, const World& world,
                 const std::vector<Meeting>& meetings, double radius) {
    const Difference off =
        difference(truth.positions[horizon], positions_of(world), torus_of(world));
    const std::span<const Meeting> known(truth.meetings);
    return {.rms = off.rms / radius,
            .max = off.max / radius,
            .unpaired = off.unpaired,
            .contacts = order_faults(known.first(truth.met[horizon]), meetings)};
}

std::vector<std::optional<double>> measured_figures(const RunWatch& watch, const World& world,
                                                    double radius) {
    std::vector<std::optional<double>> values;
    for (const Figure& figure : figures()) {
        values.push_back(figure.is_in_measure ? watch.value(figure, world) : std::nullopt);
        if (values.back() && figure.unit == Figure::Unit::length) *values.back() /= radius;
    }
    return values;
}

// The run of a choice that records everything but its cost.
std::optional<Measured> observed(Bench& bench, const Choice& choice, const Truth& truth,
                                 double radius) {
    Measured row{.choice = choice};
    Trial trial = started(bench, choice);
    const World& world = trial.world();
    RunWatch watch(bench.scene, RunWatch::Conservation::noted);
    std::vector<Meeting> meetings;
    std::uint64_t ball_ticks = 0;
    const std::uint64_t ticks = ticks_of(bench, choice.rate);
    const std::uint64_t period = ticks_each(choice.rate, bench.common);
    while (world.tick() < ticks) {
        const TickOutcome outcome = tick(bench, trial);
        if (outcome == TickOutcome::cancelled) return std::nullopt;
        if (outcome == TickOutcome::stood_still) ++row.stood_still;
        ball_ticks += world.balls().size();
        watch.note_tick(world);
        const std::size_t next = row.errors.size();
        if (next < truth.positions.size()) {
            note_meetings(meetings, trial.contacts());
            if (world.tick() == bench.points[next] * period)
                row.errors.push_back(error_at(truth, next, world, meetings, radius));
        }
    }
    row.ball_seconds = static_cast<double>(ball_ticks) / choice.rate;
    row.refused = trial.refused();
    row.figures = measured_figures(watch, world, radius);
    return row;
}

// A run for the cost only; none if it was interrupted. Reading a clock may cost as much as a tick
// of a few balls, so it is read once for several ticks.
std::optional<double> timed(Bench& bench, const Choice& choice) {
    constexpr std::uint64_t ticks_a_reading = 16;
    Trial trial = started(bench, choice);
    const World& world = trial.world();
    const std::uint64_t ticks = ticks_of(bench, choice.rate);
    const auto keep_going = [&] { return bench.hooks.go_on(bench.done, bench.total); };
    double seconds = 0.0;
    while (world.tick() < ticks) {
        const std::uint64_t until = std::min(ticks, world.tick() + ticks_a_reading);
        const double before = bench.hooks.clock();
        for (; world.tick() < until; ++bench.done)
            if (trial.tick(keep_going) == TickOutcome::cancelled) return std::nullopt;
        seconds += bench.hooks.clock() - before;
        if (!keep_going()) return std::nullopt;
    }
    return seconds;
}

std::optional<Measured> measured(Bench& bench, const Choice& choice, const Truth& truth,
                                 double radius) {
    std::optional<Measured> row = observed(bench, choice, truth, radius);
    if (!row) return std::nullopt;
    for (int i = 0; i < bench.settings.repeats; ++i) {
        const std::optional<double> seconds = timed(bench, choice);
        if (!seconds) return std::nullopt;
        row->cost.whole += *seconds / bench.settings.repeats;
        row->cost.best = i == 0 ? *seconds : std::min(row->cost.best, *seconds);
    }
    for (std::size_t i = 0; i < row->errors.size(); ++i) {
        if (!(row->errors[i].rms <= bench.settings.tolerance)) break;
        row->good_for = static_cast<double>(bench.points[i]) / bench.common;
    }
    return row;
}

std::optional<std::size_t> headline_of(const Measurement& measurement,
                                       const std::optional<double>& asked) {
    const std::vector<double>& horizons = measurement.horizons;
    if (horizons.empty()) return std::nullopt;
    if (asked) {
        const auto later = std::ranges::upper_bound(horizons, *asked * (1.0 + 1e-9));
        return later == horizons.begin() ? 0
                                         : static_cast<std::size_t>(later - horizons.begin()) - 1;
    }
    for (std::size_t i = horizons.size(); i-- > 1;) {
        const auto near = std::ranges::count_if(
            measurement.rows, [&](const Measured& row) { return row.errors[i].rms < 1.0; });
        if (4 * static_cast<std::size_t>(near) >= 3 * measurement.rows.size()) return i;
    }
    return 0;
}

Bench prepare(const Scene& scene, const MeasureSettings& settings, const LabHooks& hooks,
              const std::vector<Choice>& choices, const Reference& reference) {
    Bench bench{scene, settings, hooks};
    std::vector<double> rates{scene.world.rate(), reference.truth.rate, reference.check.rate};
    for (const Choice& choice : choices)
        rates.push_back(choice.rate);
    bench.common = common_rate(rates);
    const auto periods = [&](double time) {
        return static_cast<std::uint64_t>(std::llround(std::max(1.0, time * bench.common)));
    };
    const std::optional<double> asked = settings.horizon;
    bench.points =
        spread(periods(settings.time), asked ? std::optional(periods(*asked)) : std::nullopt);
    bench.total = ticks_of(bench, reference.truth.rate) + ticks_of(bench, reference.check.rate);
    for (const Choice& choice : choices)
        bench.total +=
            ticks_of(bench, choice.rate) * static_cast<std::uint64_t>(settings.repeats + 1);
    return bench;
}

}  // namespace

std::optional<Measurement> measure(const Scene& scene, const MeasureSettings& settings,
                                   const LabHooks& hooks) {
    const double rate = scene.world.rate();
    const std::span<const SolverKind> all = solvers_available();
    const std::vector<Choice> choices =
        choices_for(scene, settings.solvers.empty() ? all : std::span(settings.solvers),
                    settings.rates.empty() ? usual_rates(rate) : settings.rates);
    const Reference reference = reference_settings(rate);
    Bench bench = prepare(scene, settings, hooks, choices, reference);
    const double radius = mean_radius(scene.world);
    std::optional<Truth> truth = find_truth(bench, reference, radius);
    if (!truth) return std::nullopt;
    const IndependentCheck independent = check_truth(bench, *truth, radius);

    Measurement measurement{.rate = rate,
                            .seed = scene.world.seed(),
                            .balls = scene.world.balls().size(),
                            .radius = radius,
                            .time = static_cast<double>(bench.points.back()) / bench.common,
                            .repeats = settings.repeats,
                            .tolerance = settings.tolerance,
                            .own = {solver_for(scene), rate},
                            .reference = reference,
                            .horizons = {},
                            .doubts = truth->doubts,
                            .chaos = truth->chaos,
                            .independent = independent,
                            .headline = {},
                            .rows = {}};
    for (std::size_t i = 0; i < truth->positions.size(); ++i)
        measurement.horizons.push_back(static_cast<double>(bench.points[i]) / bench.common);
    for (const Choice& choice : choices) {
        std::optional<Measured> row = measured(bench, choice, *truth, radius);
        if (!row) break;
        measurement.rows.push_back(std::move(*row));
    }
    measurement.headline = headline_of(measurement, settings.horizon);
    return measurement;
}

std::optional<double> figure_of(const Measured& row, std::string_view key) {
    const auto figure = std::ranges::find(figures(), key, &Figure::key);
    const auto index = static_cast<std::size_t>(figure - figures().begin());
    return index < row.figures.size() ? row.figures[index] : std::nullopt;
}

std::optional<double> ns_per_ball_second(const Measured& row, double seconds) {
    if (row.ball_seconds <= 0.0) return std::nullopt;
    return seconds * 1e9 / row.ball_seconds;
}

double seconds_per_level_tick(const Measurement& measurement, const Measured& row) {
    return row.cost.best / (measurement.time * measurement.rate);
}

double headline_error(const Measurement& measurement, const Measured& row) {
    return row.errors[*measurement.headline].rms;
}

std::vector<Tradeoff> tradeoffs(const Measurement& measurement) {
    std::vector<Tradeoff> pairs;
    for (const Measured& row : measurement.rows)
        pairs.push_back(
            {seconds_per_level_tick(measurement, row), worst_fault(measurement, row).share});
    return pairs;
}

}  // namespace carom
