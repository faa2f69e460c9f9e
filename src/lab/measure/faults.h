#pragma once

#include <array>
#include <limits>
#include <string_view>

#include "lab/measure/measure.h"

/// What is wrong with a choice, in units of what a good one promises, so that unlike quantities can
/// be compared: 1 is the most that is acceptable, and whatever is worst decides.
namespace carom {

/// The promises. They are what `contact`, the least exact solver that promises anything, keeps.
inline constexpr double promised_overlap = 0.02;  ///< radii
/// Drift of energy relative to the largest kinetic energy; where a scene loses energy, its rise.
inline constexpr double promised_drift = 0.01;
/// What must never happen counts so much each time: a ball that gets out, a tick in which time
/// stands still, a command of a recording that is refused.
inline constexpr double never = 1000.0;

struct Fault {
    std::string_view name;
    double share = 0.0;  ///< of the promise; may be infinite
};

/// error: the error at the headline horizon, or the reference's own uncertainty there if that is
/// more, by MeasureSettings::tolerance; 0 without a headline, where nobody knows the error.
/// overlap, energy, escapes, standstill, refused: of the whole run, however far the reference is
/// known.
std::array<Fault, 6> faults(const Measurement& measurement, const Measured& row);

/// The largest of them; of equal ones the first.
Fault worst_fault(const Measurement& measurement, const Measured& row);

}  // namespace carom
