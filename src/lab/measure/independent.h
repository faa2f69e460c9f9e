#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "lab/hooks.h"
#include "lab/measure/difference.h"
#include "physics/world/world.h"

/// The reference of `carom measure` is `event`, checked by `event`: an error in its method would
/// not show. So it is computed once more, with 32 digits, by an oracle that shares no code with it.
namespace carom {

struct IndependentCheck {
    /// By instant, as far as it got: RMS difference from the reference, a length.
    std::vector<double> differences;
    /// Why it got no further, as part of a sentence; empty: it reached the last instant.
    std::string_view ended;
};

/// Compares the reference's positions at `times` (s, ascending) with those of the oracle. `start`:
/// the world before the first tick. It gives up after about 3 s of work, at impacts at one instant,
/// and at once in scenes with anything but gravity, restitution and fixed edges.
IndependentCheck check_independently(const World& start, std::span<const double> times,
                                     std::span<const Positions> reference,
                                     const std::function<bool()>& go_on);

}  // namespace carom
