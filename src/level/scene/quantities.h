#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "level/scene/observables.h"
#include "level/scene/physical_dimension.h"
#include "physics/world/ids.h"

/// The quantities that an `expect` can measure, and those that reports of `carom run` and `carom
/// measure` have as fields. A new quantity is a row in quantities.cpp. If it needs more than the
/// present world or the largest value so far, it is computed in the laboratory by its name: in
/// lab/run/figures.cpp, for bins in lab/run/judge.cpp, for observables in lab/observe.
namespace carom {

class World;

enum class QuantityScope : std::uint8_t {
    world,  ///< computed from the present world, as in `expect energy`
    run,    ///< over all ticks so far, or relative to the start, as in `expect overlap`
    ball,   ///< of a named ball that still exists, as in `expect cue.x`
    bins,   ///< of a group of bins, as in `expect mean(bins)`; the leftmost bin counts as 0
    edges,  ///< of the edges of one name, as in `expect pressure(wall)`
};

/// A field in the reports of `carom run` and `carom measure`, and a column in CSV.
struct ReportField {
    enum class Unit : std::uint8_t {
        number,  ///< in the units of the level
        count,   ///< a whole number
        length,  ///< in the units of the level; `carom measure` reports it in ball radii
    };

    std::string_view key;      ///< empty: no field
    std::string_view head;     ///< of its column in the table of `carom measure`
    std::string_view summary;  ///< its line in the summary of `carom run`; empty: none
    Unit unit = Unit::number;
    bool is_in_run = false;      ///< whether the report of `carom run` has the field
    bool is_in_measure = false;  ///< whether `carom measure` has the field
};

struct QuantityRow {
    std::string_view name;     ///< as written in levels
    std::string_view meaning;  ///< in one line
    QuantityScope scope = QuantityScope::world;
    Dimension dimension{};  ///< all 0: a pure number
    // How it is computed: the function of its scope, or none.
    double (*of_world)(const World& world) = nullptr;
    /// Of scope `run`: the largest value at the end of any tick.
    double (*at_tick)(const World& world) = nullptr;
    /// Pre: `ball` is a row of world.balls().
    double (*of_ball)(const World& world, std::size_t ball) = nullptr;
    ReportField field;
    /// The observable that it is measured with; its scope is `run` or `edges`.
    std::optional<Observable> observable{};
};
/// A row of quantities(), never null in a loaded level.
using QuantityKind = const QuantityRow*;

struct Quantity {
    QuantityKind kind = nullptr;
    BallId ball{};  ///< of scope `ball`
    /// Of scope `bins`: indices into Ledger::counters, from left to right ...
    std::vector<std::uint32_t> counters;
    /// ... and the expected share of each, for variance_ratio and chi_square: from the level's
    /// `show histogram` of the same bins, else the binomial distribution of fair tosses.
    std::vector<double> expected;
    std::vector<CapsuleId> edges{};  ///< of scope `edges`
};

bool is_of_ball(QuantityKind kind);
bool is_of_bins(QuantityKind kind);
/// The name in levels: "collisions", "x", "mean".
std::string_view name(QuantityKind kind);
/// All quantities, in the order in which messages and reports list them.
std::span<const QuantityRow> quantities();
/// The quantity of this name; null if there is none. `has_subject`: that of scope `edges`, if there
/// are two, as in "pressure(wall)".
QuantityKind quantity_named(std::string_view name, bool has_subject = false);
/// The quantity of a word such as "energy", "cue.x" or "mean(bins)"; null if there is none.
QuantityKind quantity_in(std::string_view word);

/// The probabilities of k hits in n tosses with probability p, for k = 0..n. Computed by recurrence
/// from the most likely k, so no relevant value over- or underflows; they add up to 1 within
/// rounding. Pre: n >= 0, 0 <= p <= 1.
std::vector<double> binomial_shares(int n, double p);

}  // namespace carom
