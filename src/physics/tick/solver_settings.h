#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Which solver moves a world, how finely, and how that is written in levels, reports and
/// recordings.
namespace carom {

enum class SolverKind : std::uint8_t { discrete, substep, swept, contact, event };

/// Which solver, and its settings. A setting that a solver does not have is ignored by it.
struct SolverSettings {
    SolverKind kind = SolverKind::swept;
    int updates = 4;   ///< substep: simulation updates a tick, 1..1000
    int steps = 15;    ///< substep: most steps in one update, 1..1000
    int substeps = 1;  ///< swept: straight pieces that a tick's paths are cut into, 1..1000
    /// contact: parts that a tick is cut into, 1..1000; where nothing can press no more than these
    /// (contact_flights.h).
    int contact_substeps = 4;
    /// event: computed with about 32 digits (geometry/double_double.h), as a reference for itself
    /// and others. About 5 times slower in a gas. Its paths are not part of the world, so only one
    /// solver object that ticks without interruption has all the digits. It hands no heaps over.
    bool extended = false;

    friend bool operator==(const SolverSettings&, const SolverSettings&) = default;
};

/// "discrete", "substep" ...
std::string_view name(SolverKind kind);
/// By name, exactly; none when there is no such solver.
std::optional<SolverKind> solver_named(std::string_view name);

/// A setting that is a count: its name in levels, reports and recordings, and where it is kept.
struct SolverCount {
    std::string_view name;  ///< "updates", "steps" or "substeps"
    int SolverSettings::*value = nullptr;
};
inline constexpr int most_solver_count = 1000;

/// The counts that this solver uses, in the order in which they are written.
std::vector<SolverCount> counts_of(SolverKind kind);
/// Every count: what `kind` does not use is there too. "substeps" is that of `kind`.
std::array<SolverCount, 3> all_counts(SolverKind kind);
/// Whether every count is in 1..most_solver_count, also those that the solver does not use.
bool are_in_range(const SolverSettings& settings);

/// Substeps of `contact` or, for every other solver, those of `swept`.
int substeps_of(const SolverSettings& settings);

/// How much of the settings a text has.
enum class SettingsText : std::uint8_t {
    used,      ///< all that the solver uses, as a level says it: "substep updates=4 steps=15"
    unusual,   ///< what differs from the defaults: "substep", "swept substeps=4", "event extended"
    recorded,  ///< every count, as recordings have it: "event updates=4 steps=15 substeps=1"
};
std::string settings_text(const SolverSettings& settings, SettingsText which);

/// Reads "NAME COUNT=N ..." with any of `all_counts`, each at most once and 1..most_solver_count;
/// what is absent keeps its default. Reads back what `settings_text` writes, but for "extended".
/// None when the text is anything else.
std::optional<SolverSettings> parse_solver_settings(std::string_view text);

}  // namespace carom
