#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Which solver advances a world, with which settings, and how both are written in levels, reports
/// and recordings.
namespace carom {

enum class SolverKind : std::uint8_t { discrete, substep, swept, contact, event };

/// A solver and its settings. A solver ignores the settings of others.
struct SolverSettings {
    SolverKind kind = SolverKind::swept;
    int updates = 4;   ///< substep: simulation updates a tick, 1..1000
    int steps = 15;    ///< substep: most steps in one update, 1..1000
    int substeps = 1;  ///< swept: substeps a tick, in each of which balls move straight, 1..1000
    /// contact: substeps a tick, 1..1000. Where nothing can press, `swept` takes as many at most
    /// (contact/swept_fallback.h).
    int contact_substeps = 4;
    /// event: computed with about 32 digits (geometry/double_double.h), as a reference for itself
    /// and others. About 5 times slower in a gas. Its trajectories are not part of the world, so
    /// only one solver object that ticks without interruption has all the digits. It never steps
    /// clusters with `contact`.
    bool extended = false;

    friend bool operator==(const SolverSettings&, const SolverSettings&) = default;
};

/// "discrete", "substep" ...
std::string_view name(SolverKind kind);
/// The solver with exactly this name, if there is one.
std::optional<SolverKind> solver_named(std::string_view name);

/// A setting that is a count: its name in levels, reports and recordings, and its member.
struct SolverCount {
    std::string_view name;  ///< "updates", "steps" or "substeps"
    int SolverSettings::*value = nullptr;
};
inline constexpr int most_solver_count = 1000;

/// The counts that this solver uses, in the order in which they are written.
std::vector<SolverCount> counts_of(SolverKind kind);
/// Every count, whether `kind` uses it or not. "substeps" is that of `kind`.
std::array<SolverCount, 3> all_counts(SolverKind kind);
/// Whether every count is in 1..most_solver_count, including those that the solver does not use.
bool are_in_range(const SolverSettings& settings);

/// Substeps of `contact` or, for every other solver, those of `swept`.
int substeps_of(const SolverSettings& settings);

/// How much of the settings a text says.
enum class SettingsText : std::uint8_t {
    used,      ///< all that the solver uses, as in levels: "substep updates=4 steps=15"
    unusual,   ///< what differs from the defaults: "substep", "swept substeps=4", "event extended"
    recorded,  ///< every count, as in recordings: "event updates=4 steps=15 substeps=1"
};
std::string settings_text(const SolverSettings& settings, SettingsText which);

/// Reads "NAME COUNT=N ..." with any of `all_counts`, each at most once and 1..most_solver_count;
/// counts left out keep their defaults. Reads what `settings_text` writes, except "extended": a
/// reference for measurements, which no level or recording can ask for. None for any other text.
std::optional<SolverSettings> parse_solver_settings(std::string_view text);

}  // namespace carom
