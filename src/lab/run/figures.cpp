#include "lab/run/figures.h"

#include <algorithm>

namespace carom {
namespace {

// The drifts of conserved quantities, then the quantities that have a field.
std::vector<Figure> table() {
    std::vector<Figure> all{
        {{.key = "energy_drift", .head = "energy", .is_in_measure = true},
         nullptr,
         [](const RunWatch& run, const World&) {
             return run.conservation() ? run.conservation()->energy_drift() : std::nullopt;
         }},
        {{.key = "momentum_drift", .head = "mom.", .is_in_measure = true},
         nullptr,
         [](const RunWatch& run, const World&) {
             return run.conservation() ? run.conservation()->momentum_drift() : std::nullopt;
         }},
    };
    for (const QuantityRow& quantity : quantities())
        if (!quantity.field.key.empty()) all.push_back({quantity.field, &quantity, nullptr});
    return all;
}

}  // namespace

std::span<const Figure> figures() {
    static const std::vector<Figure> all = table();
    return all;
}

RunWatch::RunWatch(const Scene& scene, Conservation conservation)
    : escape_(scene), largest_(quantities().size(), 0.0) {
    if (conservation == Conservation::noted) conservation_.emplace(scene.world);
}

void RunWatch::note_tick(const World& world) {
    for (std::size_t i = 0; i < largest_.size(); ++i)
        if (const auto at_tick = quantities()[i].at_tick)
            largest_[i] = std::max(largest_[i], at_tick(world));
    escape_.note_births(world);
    if (conservation_) conservation_->note(world);
}

std::optional<double> RunWatch::value(const Figure& figure, const World& world) const {
    return figure.of_run ? figure.of_run(*this, world) : value(figure.quantity, world);
}

void RunWatch::observe(const Scene& scene, const SolverSettings& solver) {
    const ObservableSet what = observed_of(scene);
    if (!what.is_empty()) observer_.emplace(scene, solver, what, scene.world);
}

void RunWatch::observe_tick(const Scene& scene, const World& world,
                            std::span<const Contact> contacts) {
    if (observer_) observer_->note_tick(scene, world, contacts);
}

double RunWatch::value(QuantityKind quantity, const World& world) const {
    if (quantity->of_world) return quantity->of_world(world);
    if (quantity->at_tick)
        return largest_[static_cast<std::size_t>(quantity - quantities().data())];
    // `escaped` alone is relative to the start.
    return static_cast<double>(escape_.escaped(world));
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
