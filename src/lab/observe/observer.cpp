#include "lab/observe/observer.h"

#include <fmt/format.h>

#include <cmath>

namespace carom {

ObservableSet observed_of(const Scene& scene) {
    ObservableSet what = scene.observation.what;
    for (const Show& show : scene.shows)
        if (show.what == Show::What::observable) what.add(show.observable);
    for (const Expect& expect : scene.expects)
        if (expect.what.kind->observable) what.add(*expect.what.kind->observable);
    return what;
}

Observer::Observer(const Scene& scene, const SolverSettings& solver, ObservableSet what,
                   const World& start)
    : what_(what), from_(scene.observation.from) {
    if (what_.has(Observable::lyapunov)) lyapunov_.emplace(solver, start);
    if (start.time() >= from_) begin(scene, start);
}

void Observer::begin(const Scene& scene, const World& world) {
    using enum Observable;
    has_begun_ = true;
    if (what_.has(pressure)) pressure_.emplace(scene, world);
    if (what_.has(msd) || what_.has(vacf)) displacement_.emplace(world);
    if (what_.has(speeds)) speeds_.emplace();
    if (what_.has(pairs)) pairs_.emplace(scene, world);
    if (lyapunov_) lyapunov_->restart_count(world);
}

void Observer::note_tick(const Scene& scene, const World& world,
                         std::span<const Contact> contacts) {
    if (lyapunov_) lyapunov_->note_tick(world);
    if (!has_begun_) {
        const auto first_tick = static_cast<std::uint64_t>(std::ceil(from_ * world.rate()));
        if (world.tick() >= first_tick) begin(scene, world);
        return;
    }
    if (pressure_) pressure_->note_tick(scene, world, contacts);
    if (displacement_) displacement_->note_tick(world);
    if (speeds_) speeds_->note_tick(world);
    if (pairs_) pairs_->note_tick(world);
}

std::vector<ObservedValue> Observer::values(Observable what, const World& world) const {
    const bool has = has_begun_;
    switch (what) {
        case Observable::pressure:
            return {{"pressure", has ? pressure_->pressure() : std::nullopt},
                    {"kinetic_part", has ? pressure_->kinetic_part() : std::nullopt}};
        case Observable::msd:
            return {{"msd", has ? displacement_->msd() : std::nullopt}};
        case Observable::vacf:
            return {{"vacf", has ? displacement_->vacf() : std::nullopt}};
        case Observable::speeds:
            return {{"speed_distance", has ? speed_distance(world) : std::nullopt},
                    {"speed_kurtosis", has ? speed_kurtosis(world) : std::nullopt}};
        case Observable::pairs:
            return {{"contact_value", has ? pairs_->contact_value() : std::nullopt}};
        case Observable::lyapunov:
            break;
    }
    return {{"lyapunov_exponent", has ? lyapunov_->exponent() : std::nullopt},
            {"lyapunov_time", has ? lyapunov_->time() : std::nullopt}};
}

std::optional<double> Observer::value(const Quantity& quantity, const World& world) const {
    const Observable what = *quantity.kind->observable;
    if (!what_.has(what)) return std::nullopt;
    if (quantity.kind->scope == QuantityScope::edges)
        return has_begun_ ? pressure_->pressure_on(world, quantity.edges) : std::nullopt;
    for (const auto& [name, value] : values(what, world))
        if (name == quantity.kind->name) return value;
    return std::nullopt;
}

Curve Observer::curve(Observable what) const {
    if (!has_begun_) return {};
    switch (what) {
        case Observable::pressure:
            return pressure_->curve();
        case Observable::msd:
            return displacement_->msd_curve();
        case Observable::vacf:
            return displacement_->vacf_curve();
        case Observable::speeds:
            return speeds_->curve();
        case Observable::pairs:
            return pairs_->curve();
        case Observable::lyapunov:
            break;
    }
    return lyapunov_->curve();
}

void write_observed(JsonWriter& json, const Observer* observer, const World& world) {
    json.key("observed");
    json.begin_object(JsonWriter::Layout::lines);
    for (const ObservableRow& row : observables()) {
        if (!observer || !observer->what().has(row.what)) continue;
        json.key(row.name);
        json.begin_object(JsonWriter::Layout::one_line);
        for (const auto& [name, value] : observer->values(row.what, world)) {
            json.key(name);
            value ? json.value(*value) : json.null();
        }
        json.key("curve");
        json.begin_list(JsonWriter::Layout::one_line);
        for (const CurvePoint& point : observer->curve(row.what).points) {
            json.begin_list(JsonWriter::Layout::one_line);
            json.value(point.x);
            json.value(point.y);
            if (point.expected) json.value(*point.expected);
            json.end_list();
        }
        json.end_list();
        json.end_object();
    }
    json.end_object();
}

std::string curves_csv(const Observer& observer) {
    std::string text = "observable,x,y,expected\n";
    for (const ObservableRow& row : observables()) {
        if (!observer.what().has(row.what)) continue;
        for (const CurvePoint& point : observer.curve(row.what).points) {
            text += fmt::format("{},{},{},", row.name, point.x, point.y);
            if (point.expected) text += fmt::format("{}", *point.expected);
            text += '\n';
        }
    }
    return text;
}

std::string observed_text(const Observer& observer, const World& world) {
    std::string text;
    for (const ObservableRow& row : observables()) {
        if (!observer.what().has(row.what)) continue;
        for (const auto& [name, value] : observer.values(row.what, world))
            text += value ? fmt::format("{:<17} {:.6g}\n", name, *value)
                          : fmt::format("{:<17} no value\n", name);
    }
    return text;
}

}  // namespace carom
