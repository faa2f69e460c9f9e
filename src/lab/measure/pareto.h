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

/// Which of them are on the Pareto front: nothing else costs less and errs less, or is as good in
/// one and better in the other. Of several that are equal in both, the first. Neither infinite
/// errors nor numbers that are none are ever on it.
std::vector<bool> pareto_front(std::span<const Tradeoff> choices);

/// The least error whose cost is `budget` or less; of several, the cheapest, then the first. None:
/// nothing is that cheap, or errs finitely.
std::optional<std::size_t> most_accurate_within(std::span<const Tradeoff> choices, double budget);

/// The least cost whose error is `tolerance` or less; of several, the most accurate, then the
/// first.
std::optional<std::size_t> cheapest_within(std::span<const Tradeoff> choices, double tolerance);

}  // namespace carom
