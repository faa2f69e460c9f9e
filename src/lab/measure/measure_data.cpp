#include "lab/measure/measure_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "lab/json.h"
#include "lab/measure/faults.h"
#include "lab/measure/pareto.h"

namespace carom {
namespace {

using Layout = JsonWriter::Layout;

void write_optional(JsonWriter& json, std::string_view key, const std::optional<double>& value) {
    json.key(key);
    if (value) {
        json.value(*value);
    } else {
        json.null();
    }
}

void write_choice(JsonWriter& json, const Choice& choice) {
    json.field("solver", name(choice.solver.kind));
    json.key("settings");
    write_settings(json, choice.solver);
    json.field("rate", choice.rate);
}

void write_reference(JsonWriter& json, std::string_view key, const Choice& choice) {
    json.key(key);
    json.begin_object(Layout::one_line);
    write_choice(json, choice);
    json.end_object();
}

void write_independent(JsonWriter& json, const Measurement& measurement) {
    const IndependentCheck& check = measurement.independent;
    const bool is_there = !check.differences.empty();
    json.key("independent");
    json.begin_object(Layout::one_line);
    write_optional(json, "until",
                   is_there ? std::optional(measurement.horizons[check.differences.size() - 1])
                            : std::nullopt);
    write_optional(
        json, "rms",
        is_there ? std::optional(*std::ranges::max_element(check.differences)) : std::nullopt);
    json.field("ended", check.ended);
    json.end_object();
}

void write_errors(JsonWriter& json, const Measurement& measurement, const Measured& row) {
    json.key("errors");
    json.begin_list(Layout::lines);
    for (std::size_t i = 0; i < row.errors.size(); ++i) {
        const ErrorAt& error = row.errors[i];
        json.begin_object(Layout::one_line);
        json.field("time", measurement.horizons[i]);
        json.field("rms", error.rms);
        json.field("max", error.max);
        json.field("unpaired", std::uint64_t{error.unpaired});
        json.field("missed", std::uint64_t{error.contacts.missed});
        json.field("extra", std::uint64_t{error.contacts.extra});
        json.field("out_of_order", std::uint64_t{error.contacts.out_of_order});
        json.end_object();
    }
    json.end_list();
}

void write_faults(JsonWriter& json, const Measurement& measurement, const Measured& row) {
    json.key("faults");
    json.begin_object(Layout::one_line);
    for (const Fault& fault : faults(measurement, row)) {
        // Without a headline nobody knows the error.
        const bool is_known = measurement.headline || fault.name != "error";
        write_optional(json, fault.name, is_known ? std::optional(fault.share) : std::nullopt);
    }
    json.field("worst", worst_fault(measurement, row).name);
    json.end_object();
}

void write_cost(JsonWriter& json, const Measurement& measurement, const Measured& row,
                bool on_front) {
    json.key("cost");
    json.begin_object(Layout::one_line);
    write_optional(json, "ns_per_ball_second", ns_per_ball_second(row, row.cost.whole));
    write_optional(json, "best_ns_per_ball_second", ns_per_ball_second(row, row.cost.best));
    json.field("seconds_per_level_tick", seconds_per_level_tick(measurement, row));
    json.field("pareto", on_front);
    json.end_object();
}

void write_rows(JsonWriter& json, const Measurement& measurement) {
    const std::vector<bool> front = pareto_front(tradeoffs(measurement));
    json.key("choices");
    json.begin_list(Layout::lines);
    for (std::size_t i = 0; i < measurement.rows.size(); ++i) {
        const Measured& row = measurement.rows[i];
        json.begin_object(Layout::lines);
        write_choice(json, row.choice);
        json.field("own", row.choice == measurement.own);
        json.field("good_for", row.good_for);
        for (std::size_t k = 0; k < figures().size(); ++k)
            if (figures()[k].is_in_measure) write_figure(json, figures()[k], row.figures[k]);
        json.field("stood_still_ticks", row.stood_still);
        json.field("refused", row.refused);
        write_faults(json, measurement, row);
        write_errors(json, measurement, row);
        write_cost(json, measurement, row, front[i]);
        json.end_object();
    }
    json.end_list();
}

// `row`: the choice that was picked.
void write_pick(JsonWriter& json, std::string_view key, double asked,
                std::optional<std::size_t> row, const Measurement& measurement) {
    json.key(key);
    json.begin_object(Layout::one_line);
    json.field("asked", asked);
    json.key("choice");
    if (row) {
        json.begin_object(Layout::one_line);
        write_choice(json, measurement.rows[*row].choice);
        json.end_object();
    } else {
        json.null();
    }
    json.end_object();
}

void write_picks(JsonWriter& json, const Measurement& measurement,
                 const std::optional<double>& budget, const std::optional<double>& tolerance) {
    const std::vector<Tradeoff> pairs = tradeoffs(measurement);
    json.key("picks");
    json.begin_object(Layout::lines);
    if (budget) write_pick(json, "budget", *budget, best_within(pairs, *budget), measurement);
    if (tolerance)
        write_pick(json, "tolerance", *tolerance, cheapest_within(pairs, 1.0), measurement);
    json.end_object();
}

// Reads back to the same double; empty without a value.
std::string csv_number(const std::optional<double>& value) {
    if (!value || !std::isfinite(*value)) return {};
    return fmt::format("{}", *value);
}

// For each figure, its cell and a comma.
std::string csv_figures(const Measured& row) {
    std::string cells;
    for (std::size_t i = 0; i < figures().size(); ++i) {
        if (figures()[i].is_in_measure) cells += csv_number(row.figures[i]) + ",";
    }
    return cells;
}

// Empty if the solver does not use that count.
std::string csv_count(const SolverSettings& solver, std::string_view name) {
    for (const SolverCount& count : counts_of(solver.kind))
        if (count.name == name) return fmt::format("{}", solver.*count.value);
    return {};
}

}  // namespace

std::string measure_json(std::string_view level, const Measurement& measurement,
                         const std::optional<double>& budget,
                         const std::optional<double>& tolerance) {
    JsonWriter json;
    json.begin_object(Layout::lines);
    json.field("level", level);
    json.field("rate", measurement.rate);
    json.field("seed", measurement.seed);
    json.field("balls", std::uint64_t{measurement.balls});
    json.field("radius", measurement.radius);
    json.field("time", measurement.time);
    json.field("tolerance", measurement.tolerance);
    write_reference(json, "reference", measurement.reference.truth);
    write_reference(json, "check", measurement.reference.check);
    json.key("doubts");
    json.begin_list(Layout::lines);
    for (std::size_t i = 0; i < measurement.horizons.size(); ++i) {
        json.begin_object(Layout::one_line);
        json.field("time", measurement.horizons[i]);
        json.field("rms", measurement.doubts[i]);
        json.end_object();
    }
    json.end_list();
    write_optional(json, "chaos", measurement.chaos);
    write_independent(json, measurement);
    write_optional(json, "horizon",
                   measurement.headline ? std::optional(measurement.horizons[*measurement.headline])
                                        : std::nullopt);
    write_rows(json, measurement);
    write_picks(json, measurement, budget, tolerance);
    json.end_object();
    return std::move(json).text();
}

std::string measure_csv(const Measurement& measurement) {
    const std::vector<bool> front = pareto_front(tradeoffs(measurement));
    std::string text =
        "solver,updates,steps,substeps,rate,time,rms,max,unpaired,missed,extra,out_of_order,";
    for (const Figure& figure : figures())
        if (figure.is_in_measure) text += fmt::format("{},", figure.key);
    text +=
        "worst,fault,ns_per_ball_second,best_ns_per_ball_second,seconds_per_level_tick,pareto\n";
    for (std::size_t i = 0; i < measurement.rows.size(); ++i) {
        const Measured& row = measurement.rows[i];
        const SolverSettings& solver = row.choice.solver;
        const Fault worst = worst_fault(measurement, row);
        for (std::size_t k = 0; k < row.errors.size(); ++k) {
            const ErrorAt& error = row.errors[k];
            text += fmt::format(
                "{},{},{},{},{},{},{},{},{},{},{},{},{}{},{},{},{},{},{}\n", name(solver.kind),
                csv_count(solver, "updates"), csv_count(solver, "steps"),
                csv_count(solver, "substeps"), row.choice.rate, measurement.horizons[k],
                csv_number(error.rms), csv_number(error.max), error.unpaired, error.contacts.missed,
                error.contacts.extra, error.contacts.out_of_order, csv_figures(row), worst.name,
                csv_number(worst.share), csv_number(ns_per_ball_second(row, row.cost.whole)),
                csv_number(ns_per_ball_second(row, row.cost.best)),
                seconds_per_level_tick(measurement, row), front[i] ? 1 : 0);
        }
    }
    return text;
}

}  // namespace carom
