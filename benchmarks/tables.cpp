#include "tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figures.h"
#include "lab/table.h"

namespace carom::bench {
namespace {

constexpr double bar_length = 30.0;

std::string bar(double value, double largest) {
    const double length = std::round(bar_length * value / largest);
    return std::string(std::max(1, static_cast<int>(length)), '#');
}

std::string or_dash(const std::optional<double>& value, std::string (*text)(double)) {
    return value ? text(*value) : "-";
}

// The time that a table shows: of a whole run where runs differ in length, else of a tick.
double shown_time(const SceneResults& scene, const Result& result) {
    return scene.scene.sort == SceneSort::galton ? result.median_seconds()
                                                 : result.milliseconds_a_tick();
}

std::vector<std::string> heads(SceneSort sort) {
    switch (sort) {
        case SceneSort::gas:
            return {"<engine", "ms a tick",   "speed/Chipmunk", "energy",
                    "overlap", "error 0.1 s", "runs",           "<time"};
        case SceneSort::pile:
            return {"<engine",        "ms a tick", "speed/Chipmunk", "overlap",
                    "residual speed", "runs",      "<time"};
        case SceneSort::galton:
            return {"<engine", "s a run", "speed/Chipmunk", "landed after",
                    "overlap", "runs",    "<time"};
    }
    return {};
}

std::vector<std::string> cells(const SceneResults& scene, const Result& result, double reference,
                               double largest) {
    const double time = shown_time(scene, result);
    std::vector<std::string> row{result.contestant.name, figure(time),
                                 reference > 0.0 ? figure(reference / time) : "-"};
    const Accuracy accuracy = result.accuracy();
    const auto landed = [&scene, &result] {
        const bool has = result.ticks < static_cast<double>(scene.scene.plan.ticks);
        return has ? fmt::format("{} ticks", grouped(result.ticks)) : std::string("never");
    };
    switch (scene.scene.sort) {
        case SceneSort::gas:
            row.push_back(or_dash(accuracy.energy_drift, change));
            row.push_back(small_figure(accuracy.deepest_overlap));
            row.push_back(or_dash(accuracy.error, small_figure));
            break;
        case SceneSort::pile:
            row.push_back(small_figure(accuracy.deepest_overlap));
            row.push_back(small_figure(accuracy.residual_speed));
            break;
        case SceneSort::galton:
            row.push_back(landed());
            row.push_back(small_figure(accuracy.deepest_overlap));
            break;
    }
    row.push_back(std::to_string(result.seconds.size()));
    row.push_back(bar(time, largest));
    return row;
}

std::string_view word(Verdict verdict) {
    switch (verdict) {
        case Verdict::target_met:
            return "target met";
        case Verdict::required_met:
            return "required met";
        case Verdict::missed:
            return "MISSED";
    }
    return "";
}

std::string goal_figure(double value) {
    return std::abs(value) < 1e-3 ? small_figure(value) : figure(value);
}

}  // namespace

std::string scene_table(const SceneResults& scene) {
    if (!scene.error.empty()) return fmt::format("left out: {}\n", scene.error);
    double reference = 0.0;
    double largest = 0.0;
    for (const Result& result : scene.results) {
        largest = std::max(largest, shown_time(scene, result));
        if (result.contestant.name == chipmunk) reference = shown_time(scene, result);
    }
    Table table(heads(scene.scene.sort));
    for (const Result& result : scene.results)
        table.add(cells(scene, result, reference, largest));
    std::string text = table.text();
    if (!scene.absent.empty())
        text += fmt::format("absent or failed: {}\n", fmt::join(scene.absent, ", "));
    return text;
}

std::string goals_table(const std::vector<GoalLine>& lines) {
    Table table({"<scene", "<what", "measured", "required", "target", "<"});
    for (const GoalLine& line : lines) {
        const char* sign = line.more_is_better ? ">= " : "<= ";
        table.add({line.scene, line.what, goal_figure(line.measured),
                   sign + goal_figure(line.required), sign + goal_figure(line.target),
                   std::string(word(line.verdict()))});
    }
    return table.text();
}

std::string cost_table(const OwnFigures& own) {
    Table table({"<solver", "balls", "ns a ball and tick", "bytes a ball"});
    for (const OwnCost& cost : own.costs) {
        table.add({cost.solver, grouped(static_cast<double>(cost.balls)),
                   figure(cost.ns_a_ball_tick), figure(cost.bytes_a_ball)});
    }
    return table.text();
}

std::string events_table(const OwnFigures& own) {
    Table table({"balls", "ticks a second", "collisions a second"});
    for (const OwnEvents& events : own.events) {
        table.add({grouped(static_cast<double>(events.balls)), figure(events.rate),
                   figure(events.collisions_a_second)});
    }
    return table.text();
}

std::string csv(const std::vector<SceneResults>& scenes, const OwnFigures& own) {
    std::string text =
        "scene,engine,runs,ms_a_tick,ms_best,ms_worst,ticks,energy_drift,overlap,residual_speed,"
        "error,collisions_a_second,bytes_a_ball\n";
    const auto number = [](const std::optional<double>& value) {
        return value ? fmt::format("{}", *value) : std::string();
    };
    for (const SceneResults& scene : scenes) {
        for (const Result& result : scene.results) {
            const auto [best, worst] = std::ranges::minmax(result.seconds);
            const double unit = 1e3 / result.measured;
            const Accuracy accuracy = result.accuracy();
            text += fmt::format(
                "\"{}\",\"{}\",{},{},{},{},{},{},{},{},{},,\n", scene.scene.name,
                result.contestant.name, result.seconds.size(), result.milliseconds_a_tick(),
                unit * best, unit * worst, result.ticks, number(accuracy.energy_drift),
                accuracy.deepest_overlap, accuracy.residual_speed, number(accuracy.error));
        }
    }
    for (const OwnCost& cost : own.costs) {
        const double ms = 1e-6 * cost.ns_a_ball_tick * static_cast<double>(cost.balls);
        text += fmt::format("\"gas {}\",\"carom {}\",,{},,,,,,,,,{}\n", cost.balls, cost.solver, ms,
                            cost.bytes_a_ball);
    }
    for (const OwnEvents& events : own.events) {
        text += fmt::format("\"gas {}, {} ticks a second\",\"carom event\",,,,,,,,,,{},\n",
                            events.balls, events.rate, events.collisions_a_second);
    }
    return text;
}

}  // namespace carom::bench
