#include "lab/run/figures.h"

#include <algorithm>

#include "physics/tick/totals.h"

namespace carom {
namespace {

using Value = std::optional<double>;

double counted(std::uint64_t count) {
    return static_cast<double>(count);
}

// Figures with a field of their own.
std::vector<Figure> fields() {
    using enum Figure::Unit;
    return {
        {.key = "energy_drift",
         .head = "energy",
         .is_in_measure = true,
         .of_run = [](const RunWatch& run, const World&) -> Value {
             return run.conservation() ? run.conservation()->energy_drift() : std::nullopt;
         }},
        {.key = "momentum_drift",
         .head = "mom.",
         .is_in_measure = true,
         .of_run = [](const RunWatch& run, const World&) -> Value {
             return run.conservation() ? run.conservation()->momentum_drift() : std::nullopt;
         }},
        {.quantity = "overlap",
         .key = "max_overlap",
         .head = "overlap",
         .summary = "overlap     {:.3g} at most\n",
         .unit = length,
         .is_in_run = true,
         .is_in_measure = true,
         .at_tick = [](const World& world) { return deepest_overlap(world); }},
        {.quantity = "escaped",
         .key = "escaped",
         .head = "out",
         .unit = count,
         .is_in_run = true,
         .is_in_measure = true,
         .of_run = [](const RunWatch& run, const World& world) -> Value {
             return counted(run.escape().escaped(world));
         }},
    };
}

// Figures only for `expect`: reports have them in objects and lists.
std::vector<Figure> expected_only() {
    using W = const World&;
    return {
        {.quantity = "collisions",
         .of_world =
             [](W w) { return counted(w.ball_ball_collisions() + w.ball_edge_collisions()); }},
        {.quantity = "ball_ball",
         .of_world = [](W w) { return counted(w.ball_ball_collisions()); }},
        {.quantity = "ball_edge",
         .of_world = [](W w) { return counted(w.ball_edge_collisions()); }},
        {.quantity = "kinetic_energy", .of_world = [](W w) { return totals(w).kinetic_energy; }},
        {.quantity = "potential_energy",
         .of_world = [](W w) { return totals(w).potential_energy; }},
        {.quantity = "energy",
         .of_world =
             [](W w) {
                 const Totals sums = totals(w);
                 return sums.kinetic_energy + sums.potential_energy;
             }},
        {.quantity = "momentum_x", .of_world = [](W w) { return totals(w).momentum.x; }},
        {.quantity = "momentum_y", .of_world = [](W w) { return totals(w).momentum.y; }},
        {.quantity = "angular_momentum",
         .of_world = [](W w) { return totals(w).angular_momentum; }},
        {.quantity = "time", .of_world = [](W w) { return w.time(); }},
        {.quantity = "balls", .of_world = [](W w) { return counted(w.balls().size()); }},
        {.quantity = "removed", .of_world = [](W w) { return counted(w.removed().size()); }},
    };
}

const std::vector<Figure>& table() {
    static const std::vector<Figure> rows = [] {
        std::vector<Figure> all = fields();
        const std::vector<Figure> others = expected_only();
        all.insert(all.end(), others.begin(), others.end());
        return all;
    }();
    return rows;
}

}  // namespace

std::span<const Figure> figures() {
    return table();
}

RunWatch::RunWatch(const Scene& scene, Conservation conservation)
    : escape_(scene), largest_(figures().size(), 0.0) {
    if (conservation == Conservation::noted) conservation_.emplace(scene.world);
}

void RunWatch::note_tick(const World& world) {
    for (std::size_t i = 0; i < largest_.size(); ++i)
        if (const auto at_tick = figures()[i].at_tick)
            largest_[i] = std::max(largest_[i], at_tick(world));
    escape_.note_births(world);
    if (conservation_) conservation_->note(world);
}

std::optional<double> RunWatch::value(const Figure& figure, const World& world) const {
    if (figure.of_world) return figure.of_world(world);
    if (figure.of_run) return figure.of_run(*this, world);
    return largest_[static_cast<std::size_t>(&figure - figures().data())];
}

void write_figure(JsonWriter& json, const Figure& figure, const std::optional<double>& value) {
    json.key(figure.key);
    if (!value)
        json.null();
    else if (figure.unit == Figure::Unit::count)
        json.value(static_cast<std::uint64_t>(*value));
    else
        json.value(*value);
}

}  // namespace carom
