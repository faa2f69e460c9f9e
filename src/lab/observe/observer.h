#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lab/json.h"
#include "lab/observe/curve.h"
#include "lab/observe/displacement.h"
#include "lab/observe/lyapunov.h"
#include "lab/observe/pairs.h"
#include "lab/observe/pressure.h"
#include "lab/observe/speeds.h"
#include "level/scene/scene.h"

namespace carom {

/// Everything that the level asks for: `observe`, `show`, `expect`.
ObservableSet observed_of(const Scene& scene);

/// Measures observables tick by tick, from the time `from` of the level on. What is not in the set
/// costs nothing.
class Observer {
  public:
    /// `start`: the present world; it is noted as the beginning if its time is not before `from`.
    Observer(const Scene& scene, const SolverSettings& solver, ObservableSet what,
             const World& start);

    /// Pre: called after every tick of the world, with its contacts.
    void note_tick(const Scene& scene, const World& world, std::span<const Contact> contacts);

    ObservableSet what() const { return what_; }
    bool has_begun() const { return has_begun_; }
    double from() const { return from_; }  ///< s: the time of the beginning

    /// The numbers of an observable, the first being that of its panel. They have no value before
    /// the beginning, or where they are not defined (see the meters). Pre: it is in the set.
    std::vector<ObservedValue> values(Observable what, const World& world) const;
    /// The present value of a quantity; none: it has no value, or is not in the set. Pre: it has an
    /// observable.
    std::optional<double> value(const Quantity& quantity, const World& world) const;
    /// Empty before the beginning, or without a value. Pre: it is in the set.
    Curve curve(Observable what) const;

  private:
    void begin(const Scene& scene, const World& world);

    ObservableSet what_;
    double from_ = 0.0;
    bool has_begun_ = false;
    std::optional<PressureMeter> pressure_;
    std::optional<DisplacementMeter> displacement_;
    std::optional<SpeedMeter> speeds_;
    std::optional<PairMeter> pairs_;
    std::optional<LyapunovMeter> lyapunov_;  // runs from the start, but counts from the beginning
};

/// {"pressure": {"pressure": 2.1, ..., "curve": [[0.1, 2.2], ...]}, ...}: each observable of the
/// set by its name, with its numbers and its curve. A point of a curve is [x, y], or [x, y,
/// expected].
void write_observed(JsonWriter& json, const Observer* observer, const World& world);

/// All curves as CSV: observable,x,y,expected.
std::string curves_csv(const Observer& observer);

/// A line for each observable with a value, for people.
std::string observed_text(const Observer& observer, const World& world);

}  // namespace carom
