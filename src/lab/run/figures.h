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

/// The figures that a run is told by: what `expect` compares, and what the reports of `carom run`
/// and `carom measure` say in a field of its own. One table, in figures.cpp, holds them all.
namespace carom {

class RunWatch;

struct Figure {
    enum class Unit : std::uint8_t {
        number,  ///< in the units of the level
        count,   ///< a whole number
        length,  ///< in the units of the level; `carom measure` tells it in ball radii
    };

    std::string_view quantity;  ///< as `expect` names it; empty: it cannot be expected
    std::string_view key;       ///< its field in reports and its column in CSV; empty: it has none
    std::string_view head;      ///< of its column in the table of `carom measure`
    std::string_view summary;   ///< its line in the summary of `carom run`; empty: it has none
    Unit unit = Unit::number;
    bool is_in_run = false;      ///< whether the report of `carom run` has the field
    bool is_in_measure = false;  ///< whether `carom measure` has the field
    // How it is computed, by exactly one of three:
    /// The largest that this gave at the end of any tick.
    double (*at_tick)(const World& world) = nullptr;
    /// Read off the world as it stands.
    double (*of_world)(const World& world) = nullptr;
    /// From what the watch noted, and the world as it stands; none where it has no value.
    std::optional<double> (*of_run)(const RunWatch& watch, const World& world) = nullptr;
};

/// Every figure, in the order in which reports tell them.
std::span<const Figure> figures();

/// Takes note of what the world does not remember, tick by tick.
class RunWatch {
  public:
    enum class Conservation : std::uint8_t { ignored, noted };

    /// `scene` is read here only. Noting energy and momentum costs a pass over all balls a tick.
    RunWatch(const Scene& scene, Conservation conservation);

    /// Pre: called after every tick.
    void note_tick(const World& world);

    /// The figure as the world stands, in its unit; none where it has no value.
    std::optional<double> value(const Figure& figure, const World& world) const;

    const EscapeWatch& escape() const { return escape_; }
    const std::optional<ConservationWatch>& conservation() const { return conservation_; }

  private:
    EscapeWatch escape_;
    std::optional<ConservationWatch> conservation_;
    std::vector<double> largest_;  // by figures(); 0 for a figure without `at_tick`
};

/// The figure as a field: a whole number for a count, null where there is no value.
void write_figure(JsonWriter& json, const Figure& figure, const std::optional<double>& value);

}  // namespace carom
