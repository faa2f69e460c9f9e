#include "lab/measure/measure.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "lab/measure/faults.h"
#include "lab/measure/measure_data.h"
#include "lab/measure/measure_text.h"
#include "lab/support/load.h"

using namespace carom;
using test::load;

namespace {

// A fast ball between walls without thickness, and a slow one.
const char* const thin_walls =
    "rate 60\n"
    "edge r=0  0,0  20,0  20,20  0,20  close\n"
    "ball fast at=3,10 v=900,0 r=0.5\n"
    "ball slow at=10,3 v=1,2 r=0.5\n";

const char* const crowd =
    "rate 60\n"
    "box 0,0 20,20\n"
    "kind disc r=1\n"
    "fill disc count=20 box=0,0,20,20 speed=10\n";

// On this clock each reading is a millisecond after the last; it is read before and after every 16
// ticks.
LabHooks hooks_of(double& now) {
    return {.clock = [&now] { return now += 0.001; },
            .go_on = [](std::uint64_t, std::uint64_t) { return true; }};
}

Measurement measured(const Scene& scene, const MeasureSettings& settings) {
    double now = 0.0;
    const auto measurement = measure(scene, settings, hooks_of(now));
    REQUIRE(measurement.has_value());
    return *measurement;
}

const Measured& row_of(const Measurement& measurement, const Choice& choice) {
    const auto row = std::ranges::find(measurement.rows, choice, &Measured::choice);
    REQUIRE(row != measurement.rows.end());
    return *row;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a ball that passes through a wall has an error, a missed contact, and has escaped") {
    const Measurement measurement =
        measured(load(thin_walls), {.time = 0.2, .repeats = 1, .rates = {60}});
    REQUIRE(measurement.headline.has_value());
    const std::size_t last = measurement.horizons.size() - 1;
    CHECK(measurement.horizons[last] == doctest::Approx(0.2));

    const Measured& good = row_of(measurement, {{.kind = SolverKind::swept}, 60});
    CHECK(good.errors[last].rms < 1e-9);
    CHECK(good.errors[last].contacts.missed == 0);
    CHECK(figure_of(good, "escaped") == 0);
    CHECK(good.good_for == doctest::Approx(0.2));

    const Measured& bad = row_of(measurement, {{.kind = SolverKind::discrete}, 60});
    CHECK(bad.errors[last].rms > 1.0);
    CHECK(bad.errors[last].max == doctest::Approx(bad.errors[last].rms * std::sqrt(2.0)));
    CHECK(bad.errors[last].contacts.missed > 0);
    CHECK(figure_of(bad, "escaped") == 1);
    CHECK(bad.good_for < 0.2);
    CHECK(figure_of(bad, "energy_drift") == doctest::Approx(0.0));
}

TEST_CASE("the error of event equals the reference's own uncertainty, at any rate") {
    const Measurement measurement = measured(
        load(crowd),
        {.time = 0.5, .repeats = 1, .rates = {30, 60, 120}, .solvers = {SolverKind::event}});
    REQUIRE(measurement.rows.size() == 3);
    for (const Measured& row : measurement.rows) {
        for (std::size_t i = 0; i < measurement.horizons.size(); ++i) {
            CHECK(row.errors[i].rms <= 10.0 * measurement.doubts[i] + 1e-14);
            CHECK(row.errors[i].contacts.missed == 0);
            CHECK(row.errors[i].contacts.extra == 0);
            CHECK(row.errors[i].contacts.out_of_order == 0);
        }
        CHECK(row.stood_still == 0);
    }
}

TEST_CASE("errors are in ball radii") {
    const MeasureSettings settings{.time = 0.2, .repeats = 1, .rates = {60}};
    const Measurement measurement = measured(load(thin_walls), settings);
    CHECK(measurement.radius == 0.5);
    // The fast ball flies on for ever, while its counterpart is somewhere between the walls.
    const Measured& bad = row_of(measurement, {{.kind = SolverKind::discrete}, 60});
    const double flown = 3.0 + 900.0 * 0.2;
    CHECK(bad.errors.back().max > (flown - 20.0) / 0.5);
    CHECK(bad.errors.back().max < flown / 0.5);
}

TEST_CASE("costs depend on the clock alone, all else on the level") {
    const Scene scene = load(crowd);
    const MeasureSettings settings{.time = 0.5, .repeats = 2, .rates = {30, 60}};
    const Measurement measurement = measured(scene, settings);
    const Measured& row = row_of(measurement, {{.kind = SolverKind::swept}, 30});
    CHECK(row.cost.whole == doctest::Approx(0.001));  // for 15 ticks
    CHECK(row.cost.best == doctest::Approx(0.001));
    CHECK(row.ball_seconds == doctest::Approx(20 * 0.5));
    CHECK(*ns_per_ball_second(row, row.cost.best) == doctest::Approx(1e5));
    CHECK(seconds_per_level_tick(measurement, row) == doctest::Approx(0.001 / 30));
    CHECK(measure_json("x", measurement, {}, {}) ==
          measure_json("x", measured(scene, settings), {}, {}));
}

TEST_CASE("the best of several runs is at most their mean") {
    const Scene scene = load(crowd);
    double now = 0.0;
    double step = 0.001;
    LabHooks hooks = hooks_of(now);
    hooks.clock = [&] { return now += (step *= 0.999); };
    const auto measurement =
        measure(scene, {.time = 0.2, .repeats = 3, .solvers = {SolverKind::swept}}, hooks);
    REQUIRE(measurement.has_value());
    for (const Measured& row : measurement->rows)
        CHECK(row.cost.best < row.cost.whole);
}

TEST_CASE("chaos limits the horizons that are trusted and compared") {
    const Measurement measurement =
        measured(load(crowd), {.time = 60.0, .repeats = 1, .rates = {60}});
    REQUIRE(measurement.chaos.has_value());
    REQUIRE(measurement.headline.has_value());
    CHECK(measurement.horizons.back() < *measurement.chaos);
    CHECK(measurement.doubts.size() == measurement.horizons.size());
    CHECK(measurement.doubts.back() <= measurement.tolerance);
    for (const Measured& row : measurement.rows)
        CHECK(row.errors.size() == measurement.horizons.size());
    CHECK(has(measure_text("Crowd", measurement), "chaos has grown"));
}

TEST_CASE("the horizon can be chosen") {
    const MeasureSettings settings{.time = 0.5, .repeats = 1, .rates = {60}, .horizon = 5.0 / 60.0};
    const Measurement measurement = measured(load(crowd), settings);
    REQUIRE(measurement.headline.has_value());
    CHECK(measurement.horizons[*measurement.headline] == doctest::Approx(5.0 / 60.0));
}

TEST_CASE("an interrupted measurement keeps its complete choices") {
    const Scene scene = load(crowd);
    double now = 0.0;
    LabHooks hooks = hooks_of(now);
    std::uint64_t total = 0;
    hooks.go_on = [&](std::uint64_t, std::uint64_t all) {
        total = all;
        return false;
    };
    const MeasureSettings settings{.time = 0.5, .repeats = 1, .rates = {60}};
    CHECK_FALSE(measure(scene, settings, hooks).has_value());

    hooks.go_on = [&](std::uint64_t done, std::uint64_t) { return done < total - 40; };
    const auto part = measure(scene, settings, hooks);
    REQUIRE(part.has_value());
    std::uint64_t last = 0;
    hooks.go_on = [&](std::uint64_t done, std::uint64_t) {
        last = done;
        return true;
    };
    const auto whole = measure(scene, settings, hooks);
    REQUIRE(whole.has_value());
    CHECK(last == total);
    CHECK(part->rows.size() < whole->rows.size());
    CHECK_FALSE(part->rows.empty());
    CHECK_FALSE(measure_text("Crowd", *part).empty());
}

TEST_CASE("an error below the reference's uncertainty counts as that uncertainty") {
    Measurement measurement{.time = 1.0,
                            .tolerance = 1e-3,
                            .reference = {},
                            .horizons = {1.0},
                            .doubts = {1e-10},
                            .headline = 0};
    Measured row;
    row.cost = {2.0, 1.0};
    row.errors = {{.rms = 1e-14}};
    measurement.rows = {row};
    CHECK(tradeoffs(measurement).front().fault == doctest::Approx(1e-7));
    measurement.rows.front().errors.front().rms = 1e-3;
    CHECK(tradeoffs(measurement).front().fault == doctest::Approx(1.0));
}

TEST_CASE("measure does not recommend a solver with balls inside one another") {
    const Measurement measurement =
        measured(load(crowd), {.time = 1.0, .repeats = 1, .tolerance = 10.0, .rates = {10}});
    const Measured& bad = row_of(measurement, {{.kind = SolverKind::discrete}, 10});
    CHECK(*figure_of(bad, "max_overlap") > 0.1);
    CHECK(headline_error(measurement, bad) < 10.0);
    CHECK(worst_fault(measurement, bad).share > 5.0);
    const std::string answer = tolerance_answer(measurement, 10.0);
    CHECK_FALSE(has(answer, "discrete"));
    const Measured& good = row_of(measurement, {{.kind = SolverKind::swept}, 10});
    CHECK(worst_fault(measurement, good).share <= 1.0);
}

TEST_CASE("without a known truth, the other faults decide") {
    Measurement measurement{.time = 1.0, .tolerance = 1e-3, .reference = {}};
    Measured row;
    row.cost = {1.0, 1.0};
    row.stood_still = 2;
    row.figures.resize(figures().size());
    measurement.rows = {row};
    CHECK(worst_fault(measurement, row).name == "standstill");
    CHECK(worst_fault(measurement, row).share == 2 * never);
    measurement.rows.front().stood_still = 0;
    CHECK(tradeoffs(measurement).front().fault == 0.0);
    CHECK(has(tolerance_answer(measurement, 1e-3), "nobody knows the error"));
    CHECK(has(measure_json("x", measurement, {}, {}), "\"faults\": {\"error\": null, "));
}

TEST_CASE("the tables have a row for each choice and fit 80 columns") {
    const Measurement measurement = measured(load(crowd), {.time = 0.5, .repeats = 1});
    const std::string text = measure_text("Crowd", measurement);
    for (const std::string& line : lines_of(text)) {
        CAPTURE(line);
        CHECK(line.size() <= 80);
    }
    for (const char* part : {"good for", "overlap", "doubt of the truth", "worst fault", "ms/tick"})
        CHECK(has(text, part));
    std::size_t count = 0;
    for (const std::string& line : lines_of(text))
        count += line.find(" discrete ") == 3 ? 1 : 0;
    CHECK(count == 3 * 5);
}

TEST_CASE("a budget and a tolerance name a choice, or the nearest") {
    const Measurement measurement = measured(load(thin_walls), {.time = 0.2,
                                                                .repeats = 1,
                                                                .rates = {60},
                                                                .solvers = {SolverKind::discrete},
                                                                .horizon = 0.2});
    // On this clock, 12 ticks take a millisecond.
    CHECK(has(budget_answer(measurement, 1.2e-3),
              "Within 1.2 ms a tick: discrete at 60 ticks a second (0.0833 ms, "));
    CHECK(has(budget_answer(measurement, 1e-6),
              "nothing; the cheapest is\n  discrete at 60 ticks a second, at 0.0833 ms."));
    const std::string answer = tolerance_answer(measurement, 1e-3);
    CHECK(has(answer, "nothing; the best is\n  discrete at 60 ticks a second (0.0833 ms, "));
    CHECK(has(answer, ", escapes 1.0e+03 times what is promised"));
    // The fast ball is outside, however near the truth it may be.
    Measurement near = measurement;
    near.rows.front().errors.assign(near.horizons.size(), {});
    CHECK(has(tolerance_answer(near, 1e-3), "nothing; the best is"));
    near.rows.front().figures.clear();
    CHECK(has(tolerance_answer(near, 1e-3), "Within 0.001 radii: discrete at 60 ticks a second ("));
}

TEST_CASE("the CSV has a row for each choice and horizon, and as many cells as names") {
    const Measurement measurement =
        measured(load(thin_walls), {.time = 0.2, .repeats = 1, .rates = {60}});
    const std::vector<std::string> rows = lines_of(measure_csv(measurement));
    CHECK(rows.size() == 1 + measurement.rows.size() * measurement.horizons.size());
    CHECK(rows.front().starts_with("solver,updates,steps,substeps,rate,time,rms,max,"));
    for (const std::string& row : rows) {
        CAPTURE(row);
        CHECK(std::ranges::count(row, ',') == std::ranges::count(rows.front(), ','));
    }
    CHECK(std::ranges::any_of(
        rows, [](const std::string& row) { return row.starts_with("discrete,,,,60,"); }));
    CHECK(std::ranges::any_of(
        rows, [](const std::string& row) { return row.starts_with("substep,4,15,,60,"); }));
}

TEST_CASE("the JSON has its keys, and the picked choices") {
    const Measurement measurement =
        measured(load(thin_walls), {.time = 0.2, .repeats = 1, .rates = {60}});
    const std::string json = measure_json("thin", measurement, 1.2e-3, 1e-9);
    std::size_t from = 0;
    for (const char* key :
         {"level", "rate", "seed", "balls", "radius", "time", "tolerance", "reference", "check",
          "doubts", "chaos", "horizon", "choices", "picks"}) {
        CAPTURE(key);
        const std::size_t at = json.find(std::string("\n  \"") + key + "\": ", from);
        CHECK(at != json.npos);
        from = at;
    }
    CHECK(has(json, "\"budget\": {\"asked\": 0.0012, \"choice\": {\"solver\": \""));
    CHECK(has(json, "\"tolerance\": {\"asked\": 1e-09, \"choice\": {"));
    CHECK(has(json, "\"pareto\": true"));
    CHECK(has(json, "\"reference\": {\"solver\": \"event\", \"settings\": {\"extended\": true}"));
    CHECK(has(json, "\"check\": {\"solver\": \"event\", \"settings\": {\"extended\": false}"));
    CHECK(has(measure_json("thin", measurement, 1e-9, {}), "\"choice\": null"));
}

TEST_CASE("the reference agrees with an independent computation in 32 digits") {
    const char* const scenes[] = {
        crowd,
        "rate 60\nuse gravity 0,-10\nkind disc r=0.5 e=0.9\nbox 0,0 20,20\n"
        "edge r=0.3 4,8 12,5\nedge r=0.7 14,11 14.1,11\nfill disc count=8 box=2,12,18,19 speed=4\n",
    };
    for (const char* const scene : scenes) {
        const Measurement measurement =
            measured(load(scene),
                     {.time = 0.6, .repeats = 1, .rates = {60}, .solvers = {SolverKind::event}});
        const IndependentCheck& check = measurement.independent;
        CHECK(check.ended == "");
        REQUIRE(check.differences.size() == measurement.horizons.size());
        CHECK(std::ranges::max(check.differences) < 1e-13);
        CHECK(has(measure_text("x", measurement), "Independent check with 32 digits: "));
    }
}

TEST_CASE("the independent check says where it ends") {
    // Three balls that touch meet at one instant; friction is beyond it.
    const MeasureSettings settings{
        .time = 0.6, .repeats = 1, .rates = {60}, .solvers = {SolverKind::event}};
    const Measurement row =
        measured(load("rate 60\nball a at=0,0 v=10,0 r=1\nball b at=4,0 r=1\nball c at=6,0 r=1\n"),
                 settings);
    CHECK(row.independent.ended == "impacts at one instant are beyond it");
    CHECK(row.independent.differences.size() < row.horizons.size());
    CHECK_FALSE(row.chaos);
    // A ball that lies on the floor, beside one that bounces.
    const Measurement rest = measured(load("rate 60\nuse gravity 0,-10\nmaterial m e=0.5\n"
                                           "edge m r=0 0,0 9,0\n"
                                           "ball a at=2,1 r=1\nball b at=6,2 r=1\n"),
                                      settings);
    CHECK(rest.independent.differences.empty());
    CHECK_FALSE(rest.chaos);
    const Measurement spin =
        measured(load("rate 60\nuse spin\nball a at=0,0 v=1,0 r=1\n"), settings);
    CHECK(spin.independent.differences.empty());
    CHECK(has(measure_text("x", spin), "Independent check: none, since it knows only gravity"));
}

TEST_CASE("a recording's commands reach every choice, at the time nearest to theirs") {
    MeasureSettings settings{.time = 1.0,
                             .repeats = 1,
                             .rates = {15, 60, 240},
                             .solvers = {SolverKind::swept, SolverKind::event}};
    const Scene scene = load("rate 60\nball a at=0,0 v=1,0 r=1\n");
    settings.commands = {{30, command::Strike{BallId{0}, {0.0, 8.0}}},
                         {40, command::SetSolver{{.kind = SolverKind::discrete}}},
                         {45, command::RemoveBall{BallId{7}}}};
    const Measurement measurement = measured(scene, settings);
    CHECK(measurement.independent.ended == "it knows no commands");
    for (const Measured& row : measurement.rows) {
        CHECK(row.errors.back().rms <= 0.27);
        CHECK((row.choice.rate < 60 || row.errors.back().rms < 1e-12));
        CHECK(row.refused == 1);
        CHECK(worst_fault(measurement, row).name == "refused");
    }
}
