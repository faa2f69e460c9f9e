#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// Choices on the trade-off between cost and error.
namespace carom {

struct Tradeoff {
    double cost = 0.0;
    double error = 0.0;  ///< may be infinite
};

/// Which choices are on the Pareto front: no other choice is better in one respect and at least as
/// good in the other. Of several equal choices, the first. Choices with an infinite error or a NaN
/// are never on it.
std::vector<bool> pareto_front(std::span<const Tradeoff> choices);

/// The lowest error at a cost of at most `budget`; in a tie, the cheapest, then the first. None if
/// no choice is that cheap, or none has a finite error.
std::optional<std::size_t> most_accurate_within(std::span<const Tradeoff> choices, double budget);

/// The lowest cost with an error of at most `tolerance`; in a tie, the most accurate, then the
/// first. None if no choice is that accurate.
std::optional<std::size_t> cheapest_within(std::span<const Tradeoff> choices, double tolerance);

}  // namespace carom
