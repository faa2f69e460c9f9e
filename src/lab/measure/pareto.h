#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// The trade-off between the cost of choices and their faults.
namespace carom {

struct Tradeoff {
    double cost = 0.0;
    double fault = 0.0;  ///< how bad the choice is; may be infinite
};

/// Which choices are on the Pareto front: no other choice is better in one respect and at least as
/// good in the other. Of several equal choices, the first. Choices with an infinite fault or a NaN
/// are never on it.
std::vector<bool> pareto_front(std::span<const Tradeoff> choices);

/// The lowest fault at a cost of at most `budget`; in a tie, the cheapest, then the first. None if
/// no choice is that cheap, or none has a finite fault.
std::optional<std::size_t> best_within(std::span<const Tradeoff> choices, double budget);

/// The lowest cost with a fault of at most `most`; in a tie, the lowest fault, then the first. None
/// if no choice is that good.
std::optional<std::size_t> cheapest_within(std::span<const Tradeoff> choices, double most);

}  // namespace carom
