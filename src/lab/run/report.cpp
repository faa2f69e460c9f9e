#include "lab/run/report.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "lab/json.h"
#include "lab/run/choice.h"
#include "physics/world/fingerprint.h"

namespace carom {
namespace {

using Layout = JsonWriter::Layout;

std::string_view name_at(const std::vector<std::string>& names, std::size_t index) {
    return index < names.size() ? std::string_view(names[index]) : std::string_view();
}

// The level's value of the mass: 1/(1/m) is m only up to rounding.
double mass_of(const World& world, std::size_t ball) {
    const double inverse = world.balls().inverse_mass[ball];
    const double of_kind = world.kinds()[world.balls().kind[ball]].mass;
    return 1.0 / of_kind == inverse ? of_kind : 1.0 / inverse;
}

void write_balls(JsonWriter& json, const Scene& scene, const World& world) {
    const Balls& balls = world.balls();
    json.key("balls");
    json.begin_list(Layout::lines);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        json.begin_object(Layout::one_line);
        json.field("id", std::uint64_t{number(balls.id[i])});
        json.field("name", name_at(scene.ball_names, number(balls.id[i])));
        json.field("kind", name_at(scene.kind_names, balls.kind[i]));
        json.field("x", balls.position[i].x);
        json.field("y", balls.position[i].y);
        json.field("vx", balls.velocity[i].x);
        json.field("vy", balls.velocity[i].y);
        json.field("w", world.model().spin ? balls.spin[i] : 0.0);
        json.field("radius", balls.radius[i]);
        json.field("mass", mass_of(world, i));
        json.end_object();
    }
    json.end_list();
}

void write_removed(JsonWriter& json, const Scene& scene, const World& world) {
    json.key("removed");
    json.begin_list(Layout::lines);
    for (const Removal& removal : world.ledger().removed) {
        json.begin_object(Layout::one_line);
        json.field("id", std::uint64_t{number(removal.id)});
        json.field("name", name_at(scene.ball_names, number(removal.id)));
        json.field("by", removal.zone < 0
                             ? std::string_view("player")
                             : name_at(scene.zone_names, static_cast<std::size_t>(removal.zone)));
        json.field("tick", removal.tick);
        json.end_object();
    }
    json.end_list();
}

void write_totals(JsonWriter& json, std::string_view key, const Totals& sums) {
    json.key(key);
    json.begin_object(Layout::one_line);
    json.field("kinetic_energy", sums.kinetic_energy);
    json.field("potential_energy", sums.potential_energy);
    json.key("momentum");
    json.begin_list(Layout::one_line);
    json.value(sums.momentum.x);
    json.value(sums.momentum.y);
    json.end_list();
    json.field("angular_momentum", sums.angular_momentum);
    json.end_object();
}

// Writes a list for each group, in order, then a number for each counter outside of groups, then
// the counts of the game.
void write_counters(JsonWriter& json, const Scene& scene, const World& world,
                    const RunRecord& record) {
    const std::vector<std::uint64_t> counts = census(world);
    std::vector<bool> is_grouped(counts.size(), false);
    json.key("counters");
    json.begin_object(Layout::lines);
    for (const Group& group : scene.groups) {
        if (group.counters.empty()) continue;
        json.key(group.name);
        json.begin_list(Layout::one_line);
        for (const std::uint32_t counter : group.counters) {
            json.value(counts[counter]);
            is_grouped[counter] = true;
        }
        json.end_list();
    }
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (!is_grouped[i]) json.field(name_at(scene.counter_names, i), counts[i]);
    }
    for (const auto& [name, tally] : record.tallies)
        json.field(name, tally);
    json.end_object();
}

// Nothing where the level's rules have none.
void write_variables(JsonWriter& json, const RunRecord& record) {
    if (record.variables.empty()) return;
    json.key("variables");
    json.begin_object(Layout::lines);
    for (const auto& [name, values] : record.variables) {
        if (values.size() == 1) {
            json.field(name, values.front());
            continue;
        }
        json.key(name);
        json.begin_list(Layout::one_line);
        for (const std::int64_t value : values)
            json.value(value);
        json.end_list();
    }
    json.end_object();
}

// "a.x 0.5m within 0.01m", "a.x < 0.5m always".
// "it is 0.7m", "it is 0.7m at 1.25 s".
void write_expects(JsonWriter& json, const Scene& scene, const RunRecord& record) {
    json.key("expects");
    json.begin_list(Layout::lines);
    for (std::size_t i = 0; i < scene.expects.size(); ++i) {
        const Expect& expect = scene.expects[i];
        const Judgement& judgement = record.judgements[i];
        json.begin_object(Layout::one_line);
        json.field("quantity", std::string_view(expect.quantity));
        json.field("value", expect.value);
        json.field("tolerance", expect.tolerance);
        json.field("relation", sign(expect.relation));
        json.field("when", when_word(expect));
        json.key("measured");
        judgement.measured ? json.value(*judgement.measured) : json.null();
        json.key("time");
        judgement.time ? json.value(*judgement.time) : json.null();
        if (judgement.nearest) {
            json.field("nearest", *judgement.nearest);
            json.field("nearest_time", judgement.nearest_time);
        }
        json.field("verdict", name(judgement.verdict));
        json.end_object();
    }
    json.end_list();
}

void write_solver_changes(JsonWriter& json, const RunRecord& record) {
    if (record.solver_changes.empty()) return;
    json.key("solver_changes");
    json.begin_list(Layout::lines);
    for (const SolverChange& change : record.solver_changes) {
        json.begin_object(Layout::one_line);
        json.field("tick", change.tick);
        json.field("solver", name(change.settings.kind));
        json.key("settings");
        write_settings(json, change.settings);
        json.end_object();
    }
    json.end_list();
}

void write_cost(JsonWriter& json, const RunRecord& record, double seconds) {
    const double ball_ticks = static_cast<double>(record.ball_ticks);
    json.key("cost");
    json.begin_object(Layout::one_line);
    json.field("seconds", seconds);
    json.field("ns_per_ball_tick", ball_ticks > 0.0 ? seconds * 1e9 / ball_ticks : 0.0);
    json.end_object();
}

}  // namespace

std::string report_json(std::string_view level, const Scene& scene, const World& world,
                        const RunRecord& record, double seconds) {
    JsonWriter json;
    json.begin_object(Layout::lines);
    json.field("level", level);
    json.field("solver", name(record.solver.kind));
    json.key("settings");
    write_settings(json, record.solver);
    write_solver_changes(json, record);
    json.field("rate", world.rate());
    json.field("seed", world.seed());
    json.field("ticks", world.tick());
    json.field("time", world.time());
    json.key("model");
    json.begin_list(Layout::one_line);
    for (const std::string& term : terms_in_force(world.model())) {
        json.value(std::string_view(term));
    }
    json.end_list();
    write_balls(json, scene, world);
    write_removed(json, scene, world);
    write_totals(json, "totals_start", record.totals_start);
    write_totals(json, "totals", totals(world));
    json.key("collisions");
    json.begin_object(Layout::one_line);
    json.field("ball_ball", world.ledger().ball_ball_collisions);
    json.field("ball_edge", world.ledger().ball_edge_collisions);
    json.end_object();
    for (const Figure& figure : figures())
        if (figure.is_in_run) write_figure(json, figure, record.watch.value(figure, world));
    write_counters(json, scene, world, record);
    write_variables(json, record);
    write_expects(json, scene, record);
    write_observed(json, record.watch.observer(), world);
    json.key("notes");
    write_notes(json, record.notes);
    write_cost(json, record, seconds);
    json.field("fingerprint", std::string_view(hexadecimal(fingerprint(world))));
    json.end_object();
    return std::move(json).text();
}

}  // namespace carom
