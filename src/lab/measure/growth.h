#pragma once

#include <optional>
#include <span>

/// How a small difference grows: doubling again and again where there is chaos.
namespace carom {

struct GrowthPoint {
    double time = 0.0;        ///< s
    double difference = 0.0;  ///< >= 0, in any unit
};

struct Growth {
    double doubling_time = 0.0;  ///< s
    double from = 0.0;           ///< s: the part that was fitted
    double to = 0.0;
};

/// The doubling time of the exponential part of `points`, which are in order of time: a line of
/// least squares through the logarithms of the differences, from the first that is not zero to the
/// first above `saturation`, where the two have nothing to do with each other any more.
///
/// None when there are fewer than 5 points in that part, when the difference grows less than
/// eightfold along the line, or when a power of the time since the difference began fits better
/// (two balls that fly apart steadily are no chaos).
std::optional<Growth> exponential_growth(std::span<const GrowthPoint> points, double saturation);

}  // namespace carom
