#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lab/json.h"
#include "lab/observe/observer.h"
#include "lab/run/conservation.h"
#include "lab/run/escape.h"
#include "level/scene/quantities.h"
#include "level/scene/scene.h"
#include "physics/world/world.h"

/// The figures of a run: the fields of the reports of `carom run` and `carom measure`. Most of them
/// are quantities that `expect` compares too; these are defined in level/scene/quantities.cpp.
namespace carom {

class RunWatch;

struct Figure : ReportField {
    QuantityKind quantity = nullptr;  ///< null: not available to `expect`
    /// From the watch and the world at the end, none if it has no value. Null: as its quantity.
    std::optional<double> (*of_run)(const RunWatch& watch, const World& world) = nullptr;
};

/// All figures, in the order of reports.
std::span<const Figure> figures();

/// Records, tick by tick, data that the world does not keep.
class RunWatch {
  public:
    enum class Conservation : std::uint8_t { ignored, noted };

    /// `scene` is read only in the constructor. Recording energy and momentum costs a pass over all
    /// balls per tick.
    RunWatch(const Scene& scene, Conservation conservation);

    /// Measures what the level asks for (lab/observe); nothing where it asks for nothing.
    void observe(const Scene& scene, const SolverSettings& solver);
    /// Null: nothing is observed.
    const Observer* observer() const { return observer_ ? &*observer_ : nullptr; }

    /// Records the world after a tick. Pre: called after every tick.
    void note_tick(const World& world);
    /// Passes the world and the contacts of the tick to the observer. Pre: called after every tick.
    void observe_tick(const Scene& scene, const World& world, std::span<const Contact> contacts);

    /// The present value of the figure, in its unit; none if it has no value.
    std::optional<double> value(const Figure& figure, const World& world) const;
    /// The present value of the quantity. Pre: its scope is `world` or `run`, and it has no
    /// observable.
    double value(QuantityKind quantity, const World& world) const;

    const EscapeWatch& escape() const { return escape_; }
    const std::optional<ConservationWatch>& conservation() const { return conservation_; }

  private:
    EscapeWatch escape_;
    std::optional<ConservationWatch> conservation_;
    std::optional<Observer> observer_;
    std::vector<double> largest_;  // by quantities(); 0 for one without `at_tick`
};

/// Writes the figure as a field: a whole number for a count, null without a value.
void write_figure(JsonWriter& json, const Figure& figure, const std::optional<double>& value);

}  // namespace carom
