#pragma once

#include <cstdint>
#include <functional>

namespace carom {

/// Called tick by tick, and within long ticks, with the ticks done and the ticks in total.
/// Returning false ends the work.
using GoOn = std::function<bool(std::uint64_t done, std::uint64_t total)>;

/// Services that the lab needs from its caller.
struct LabHooks {
    /// Seconds of processor time since any fixed moment: the lab has no clock of its own.
    std::function<double()> clock;
    GoOn go_on;
};

}  // namespace carom
