#pragma once

#include <optional>
#include <span>

/// How a small difference grows: exponentially in a chaotic scene.
namespace carom {

struct GrowthPoint {
    double time = 0.0;        ///< s
    double difference = 0.0;  ///< >= 0, in any unit
};

struct Growth {
    double doubling_time = 0.0;  ///< s
    double from = 0.0;           ///< s: the start of the fitted part
    double to = 0.0;
};

/// The doubling time of the exponential part of `points`, which are in order of time. The fit is a
/// least-squares line through the logarithms of the differences, from the first non-zero one to the
/// first above `saturation`, where the two runs are no longer related.
///
/// None if that part has fewer than 5 points, if the difference grows less than eightfold along the
/// line, or if a power of the time since the difference began fits better (two balls that separate
/// steadily are not chaos).
std::optional<Growth> exponential_growth(std::span<const GrowthPoint> points, double saturation);

}  // namespace carom
