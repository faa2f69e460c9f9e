#pragma once

#include <cstdint>
#include <functional>

namespace carom {

/// Told, tick by tick and within long ticks, of the ticks done and of all that there are to do;
/// false ends the work.
using GoOn = std::function<bool(std::uint64_t done, std::uint64_t total)>;

/// What the lab asks of its caller while it works.
struct LabHooks {
    /// Seconds since any moment. The lab has no clock of its own.
    std::function<double()> clock;
    GoOn go_on;
};

}  // namespace carom
