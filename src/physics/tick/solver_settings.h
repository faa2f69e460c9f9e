#pragma once

#include <cstdint>

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

}  // namespace carom
