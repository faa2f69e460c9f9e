#include "lab/measure/measure_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "lab/measure/faults.h"
#include "lab/plot.h"
#include "lab/table.h"

namespace carom {
namespace {

std::string rate_text(double rate) {
    return fmt::format("{:.6g}", rate);
}

// An error in radii, with two digits.
std::string small(double value) {
    if (!std::isfinite(value)) return "lost";
    if (value == 0.0) return "0";
    return fmt::format("{:.1e}", value);
}

std::string small(const std::optional<double>& value) {
    return value ? small(*value) : "-";
}

std::string seconds_text(double seconds) {
    return fmt::format("{:.3g} s", seconds);
}

std::string milliseconds(double seconds) {
    return fmt::format("{:.3g}", seconds * 1e3);
}

std::string named(const Choice& choice) {
    return fmt::format("{} at {} ticks a second",
                       settings_text(choice.solver, SettingsText::unusual), rate_text(choice.rate));
}

// "event extended, checked by event, at 120 ticks a second".
std::string reference_text(const Reference& reference) {
    if (reference.truth.rate != reference.check.rate)
        return fmt::format("{},\n  checked by {}", named(reference.truth), named(reference.check));
    return fmt::format("{}, checked by {}",
                       settings_text(reference.truth.solver, SettingsText::unusual),
                       named(reference.check));
}

std::string believed(const Measurement& measurement) {
    if (measurement.horizons.empty())
        return "The reference cannot be believed for even one tick: chaos is faster than that.\n";
    if (!measurement.chaos) return "The reference can be believed all of that time.\n";
    return fmt::format(
        "The reference can be believed for {}; by {} chaos has grown its last\n"
        "digits to more than {} radii.\n",
        seconds_text(measurement.horizons.back()), seconds_text(*measurement.chaos),
        fmt::format("{:g}", measurement.tolerance));
}

std::string independent(const Measurement& measurement) {
    const IndependentCheck& check = measurement.independent;
    if (check.differences.empty())
        return fmt::format("Independent check: none, since {}.\n", check.ended);
    const double most = *std::ranges::max_element(check.differences);
    return fmt::format(
        "Independent check with 32 digits: {} up to {}{}{}.\n",
        most == 0.0 ? "the same doubles" : fmt::format("within {} radii", small(most)),
        seconds_text(measurement.horizons[check.differences.size() - 1]),
        check.ended.empty() ? "" : ";\n  ", check.ended);
}

std::string heading(std::string_view title, const Measurement& measurement) {
    return fmt::format(
        "{}: {} ball{}, {} s at {} ticks a second; {}\n"
        "Reference: {}.\n{}{}",
        title, measurement.balls, measurement.balls == 1 ? "" : "s", measurement.time,
        rate_text(measurement.rate),
        measurement.repeats == 1 ? "one run of each"
                                 : fmt::format("best of {} runs", measurement.repeats),
        reference_text(measurement.reference), believed(measurement), independent(measurement));
}

// The first columns, which all tables share.
std::vector<std::string> first_cells(const Measurement& measurement, std::size_t row,
                                     const std::vector<bool>& front) {
    const Choice& choice = measurement.rows[row].choice;
    return {fmt::format("{}{}", front[row] ? 'P' : ' ', choice == measurement.own ? '*' : ' '),
            settings_text(choice.solver, SettingsText::unusual), rate_text(choice.rate)};
}

std::string cost_table(const Measurement& measurement, const std::vector<bool>& front) {
    Table table({"<", "<solver", "rate", "ms/tick", "error", "good for", "worst", "<of"});
    for (std::size_t i = 0; i < measurement.rows.size(); ++i) {
        const Measured& row = measurement.rows[i];
        std::vector<std::string> cells = first_cells(measurement, i, front);
        cells.push_back(milliseconds(seconds_per_level_tick(measurement, row)));
        cells.push_back(measurement.headline ? small(headline_error(measurement, row)) : "-");
        cells.push_back(row.good_for > 0.0 ? seconds_text(row.good_for) : "-");
        const Fault worst = worst_fault(measurement, row);
        cells.push_back(small(worst.share));
        cells.emplace_back(worst.name);
        table.add(std::move(cells));
    }
    return table.text();
}

// The figures of the table of faults: counts come after the faults in the order of contacts, the
// others before.
template <class Use>
void for_each_figure(bool is_count, const Use& use) {
    for (std::size_t i = 0; i < figures().size(); ++i) {
        const Figure& figure = figures()[i];
        if (figure.is_in_measure && (figure.unit == Figure::Unit::count) == is_count)
            use(figure, i);
    }
}

std::string fault_table(const Measurement& measurement, const std::vector<bool>& front) {
    std::vector<std::string> heads{"<", "<solver", "rate"};
    const auto add_head = [&](const Figure& figure, std::size_t) {
        heads.emplace_back(figure.head);
    };
    for_each_figure(false, add_head);
    heads.insert(heads.end(), {"miss", "extra", "order"});
    for_each_figure(true, add_head);
    Table table(heads);
    for (std::size_t i = 0; i < measurement.rows.size(); ++i) {
        const Measured& row = measurement.rows[i];
        std::vector<std::string> cells = first_cells(measurement, i, front);
        for_each_figure(false, [&](const Figure&, std::size_t figure) {
            cells.push_back(small(row.figures[figure]));
        });
        if (measurement.headline) {
            const OrderFaults& faults = row.errors[*measurement.headline].contacts;
            for (const std::size_t count : {faults.missed, faults.extra, faults.out_of_order})
                cells.push_back(fmt::format("{}", count));
        } else {
            cells.insert(cells.end(), 3, "-");
        }
        for_each_figure(true, [&](const Figure&, std::size_t figure) {
            cells.push_back(fmt::format("{}", row.figures[figure].value_or(0.0)));
        });
        table.add(std::move(cells));
    }
    return table.text();
}

// At most five of the horizons, including the last.
std::vector<std::size_t> shown_horizons(const Measurement& measurement) {
    constexpr std::size_t most = 5;
    const std::size_t count = measurement.horizons.size();
    const std::size_t shown = std::min(most, count);
    std::vector<std::size_t> indices;
    for (std::size_t i = 1; i <= shown; ++i)
        indices.push_back(count * i / shown - 1);
    return indices;
}

std::string error_table(const Measurement& measurement, const std::vector<bool>& front) {
    const std::vector<std::size_t> shown = shown_horizons(measurement);
    std::vector<std::string> heads{"<", "<solver", "rate"};
    for (const std::size_t horizon : shown)
        heads.push_back(seconds_text(measurement.horizons[horizon]));
    Table table(heads);
    for (std::size_t i = 0; i < measurement.rows.size(); ++i) {
        std::vector<std::string> cells = first_cells(measurement, i, front);
        for (const std::size_t horizon : shown)
            cells.push_back(small(measurement.rows[i].errors[horizon].rms));
        table.add(std::move(cells));
    }
    std::vector<std::string> doubts{"", "doubt of the truth", ""};
    for (const std::size_t horizon : shown)
        doubts.push_back(small(measurement.doubts[horizon]));
    table.add(std::move(doubts));
    return table.text();
}

char mark_of(SolverKind kind, bool on_front) {
    const char letter = kind == SolverKind::swept ? 'w' : name(kind).front();
    return on_front ? static_cast<char>(letter - 'a' + 'A') : letter;
}

std::string plot_of(const Measurement& measurement, const std::vector<bool>& front) {
    std::vector<PlotPoint> points;
    std::string legend;
    std::vector<SolverKind> seen;
    for (std::size_t i = 0; i < measurement.rows.size(); ++i) {
        const Measured& row = measurement.rows[i];
        const SolverKind kind = row.choice.solver.kind;
        points.push_back({.x = seconds_per_level_tick(measurement, row) * 1e3,
                          .y = worst_fault(measurement, row).share,
                          .mark = mark_of(kind, front[i]),
                          .on_front = front[i]});
        if (std::ranges::find(seen, kind) != seen.end()) continue;
        seen.push_back(kind);
        legend +=
            fmt::format("{}{} {}", legend.empty() ? "" : ", ", mark_of(kind, false), name(kind));
    }
    const std::string y_name = "worst fault, 1 is as promised; capitals: the front";
    const std::string x_name = "ms a tick; " + legend;
    const std::string plot = log_log_plot(points, {.x_name = x_name, .y_name = y_name});
    return plot.empty() ? plot : '\n' + plot;
}

// "3.1e-13 radii off, 2 balls out": the error, and what breaks a promise.
std::string blamed(const Measurement& measurement, const Measured& row) {
    std::string text = measurement.headline ? small(headline_error(measurement, row)) + " radii off"
                                            : std::string("error unknown");
    for (const Fault& fault : faults(measurement, row)) {
        if (!(fault.share > 1.0) || fault.name == "error") continue;
        text += fmt::format(", {} {} times what is promised", fault.name, small(fault.share));
    }
    return text;
}

std::string priced(const Measurement& measurement, std::size_t row) {
    const Measured& measured = measurement.rows[row];
    return fmt::format("{} ({} ms, {})", named(measured.choice),
                       milliseconds(seconds_per_level_tick(measurement, measured)),
                       blamed(measurement, measured));
}

}  // namespace

std::string measure_text(std::string_view title, const Measurement& measurement) {
    std::string text = heading(title, measurement);
    if (measurement.rows.empty()) return text;
    const std::vector<bool> front = pareto_front(tradeoffs(measurement));
    text += fmt::format(
        "\nCost: CPU time in ms for a tick of the level (1/{} s).\n"
        "Error{}: RMS of positions, in ball radii. Good for: up to {:g}.\n"
        "Worst of error, overlap, energy, escapes, standstill: 1 is as promised.\n"
        "P: on the Pareto front of cost and worst; *: what the level runs under.\n\n",
        rate_text(measurement.rate),
        measurement.headline
            ? fmt::format(" after {}", seconds_text(measurement.horizons[*measurement.headline]))
            : "",
        measurement.tolerance);
    text += cost_table(measurement, front);
    text +=
        "\nRelative drift of energy and momentum; deepest overlap, in radii; collisions\n"
        "missed, extra, and out of order by the same instant; balls that got out.\n\n";
    text += fault_table(measurement, front);
    for (const Measured& row : measurement.rows) {
        if (row.stood_still > 0)
            text += fmt::format("{}: in {} ticks time stood still for some balls.\n",
                                named(row.choice), row.stood_still);
        if (row.refused > 0)
            text += fmt::format("{}: {} commands of the recording were refused.\n",
                                named(row.choice), row.refused);
    }
    if (measurement.headline)
        text += "\nThe error as it grows:\n\n" + error_table(measurement, front);
    return text + plot_of(measurement, front);
}

std::string own_answer(const Measurement& measurement) {
    for (std::size_t i = 0; i < measurement.rows.size(); ++i)
        if (measurement.rows[i].choice == measurement.own)
            return fmt::format("As it is: {}.\n", priced(measurement, i));
    return {};
}

std::string budget_answer(const Measurement& measurement, double budget) {
    const std::vector<Tradeoff> pairs = tradeoffs(measurement);
    const std::string limit = milliseconds(budget);
    if (const auto row = best_within(pairs, budget))
        return fmt::format("Within {} ms a tick: {}.\n", limit, priced(measurement, *row));
    const auto least = std::ranges::min_element(pairs, {}, &Tradeoff::cost);
    if (least == pairs.end()) return fmt::format("Within {} ms a tick: nothing.\n", limit);
    const auto row = static_cast<std::size_t>(least - pairs.begin());
    return fmt::format("Within {} ms a tick: nothing; the cheapest is\n  {}, at {} ms.\n", limit,
                       named(measurement.rows[row].choice), milliseconds(least->cost));
}

std::string tolerance_answer(const Measurement& measurement, double tolerance) {
    const std::vector<Tradeoff> pairs = tradeoffs(measurement);
    const std::string limit =
        fmt::format("Within {:g} radii{}: ", tolerance,
                    measurement.headline ? "" : ", but nobody knows the error");
    if (const auto row = cheapest_within(pairs, 1.0))
        return fmt::format("{}{}.\n", limit, priced(measurement, *row));
    const auto least = std::ranges::min_element(pairs, {}, &Tradeoff::fault);
    if (least == pairs.end() || !std::isfinite(least->fault)) return limit + "nothing.\n";
    const auto row = static_cast<std::size_t>(least - pairs.begin());
    return fmt::format("{}nothing; the best is\n  {}.\n", limit, priced(measurement, row));
}

}  // namespace carom
