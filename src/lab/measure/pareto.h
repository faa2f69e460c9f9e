#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// Choosing between cost and error.
namespace carom {

struct Tradeoff {
    double cost = 0.0;
    double error = 0.0;  ///< may be infinite
};

/// Which choices are on the Pareto front: no other choice is better in one and at least as good in
/// the other. Of several equal ones, the first. Choices with an infinite error or a NaN never are.
std::vector<bool> pareto_front(std::span<const Tradeoff> choices);

/// The least error at a cost of `budget` or less; of several, the cheapest, then the first. None
/// where no choice is that cheap, or none has a finite error.
std::optional<std::size_t> most_accurate_within(std::span<const Tradeoff> choices, double budget);

/// The least cost with an error of `tolerance` or less; of several, the most accurate, then the
/// first. None where no choice is that accurate.
std::optional<std::size_t> cheapest_within(std::span<const Tradeoff> choices, double tolerance);

}  // namespace carom
