#pragma once

#include <array>
#include <limits>
#include <string_view>

#include "lab/measure/measure.h"

/// The faults of a choice, each divided by what is acceptable, so that unlike quantities can be
/// compared: 1 is acceptable, more is not. The worst fault decides.
namespace carom {

/// The acceptable values: those that `contact`, the least exact solver with any promises, keeps.
inline constexpr double promised_overlap = 0.02;  ///< radii
/// Drift of energy relative to the largest kinetic energy; where a scene loses energy, its rise.
inline constexpr double promised_drift = 0.01;
/// The fault of each event that must never happen: a ball that gets out, a tick in which time
/// stands still for a ball, a refused command of a recording.
inline constexpr double never = 1000.0;

struct Fault {
    std::string_view name;
    double share = 0.0;  ///< the fault by the acceptable value; may be infinite
};

/// The faults of a row:
/// - error: the error at the headline horizon, or the uncertainty of the reference there if that is
///   more, by MeasureSettings::tolerance; 0 without a headline, since then the error is unknown;
/// - overlap, energy, escapes, standstill, refused: of the whole run, however far the reference is
///   known.
std::array<Fault, 6> faults(const Measurement& measurement, const Measured& row);

/// The largest fault; in a tie, the first.
Fault worst_fault(const Measurement& measurement, const Measured& row);

}  // namespace carom
