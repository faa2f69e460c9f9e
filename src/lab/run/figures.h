#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lab/json.h"
#include "lab/run/conservation.h"
#include "lab/run/escape.h"
#include "level/scene/scene.h"
#include "physics/world/world.h"

/// The figures of a run: the quantities that `expect` compares, and those that the reports of
/// `carom run` and `carom measure` have as fields. One table, in figures.cpp, holds them all.
namespace carom {

class RunWatch;

struct Figure {
    enum class Unit : std::uint8_t {
        number,  ///< in the units of the level
        count,   ///< a whole number
        length,  ///< in the units of the level; `carom measure` reports it in ball radii
    };

    std::string_view quantity;  ///< its name in `expect`; empty: not available there
    std::string_view key;       ///< its field in reports and its column in CSV; empty: none
    std::string_view head;      ///< of its column in the table of `carom measure`
    std::string_view summary;   ///< its line in the summary of `carom run`; empty: none
    Unit unit = Unit::number;
    bool is_in_run = false;      ///< whether the report of `carom run` has the field
    bool is_in_measure = false;  ///< whether `carom measure` has the field
    // How it is computed: exactly one of three is set.
    /// The largest value at the end of any tick.
    double (*at_tick)(const World& world) = nullptr;
    /// From the world at the end.
    double (*of_world)(const World& world) = nullptr;
    /// From the watch and the world at the end; none if it has no value.
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

    /// Pre: called after every tick.
    void note_tick(const World& world);

    /// The present value of the figure, in its unit; none if it has no value.
    std::optional<double> value(const Figure& figure, const World& world) const;

    const EscapeWatch& escape() const { return escape_; }
    const std::optional<ConservationWatch>& conservation() const { return conservation_; }

  private:
    EscapeWatch escape_;
    std::optional<ConservationWatch> conservation_;
    std::vector<double> largest_;  // by figures(); 0 for a figure without `at_tick`
};

/// Writes the figure as a field: a whole number for a count, null without a value.
void write_figure(JsonWriter& json, const Figure& figure, const std::optional<double>& value);

}  // namespace carom
