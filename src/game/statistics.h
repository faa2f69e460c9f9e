#pragma once

#include <cstddef>
#include <span>

/// Statistics of a set of counts.
namespace carom {

struct Moments {
    double total = 0.0;
    double mean = 0.0;
    double variance = 0.0;  ///< about the mean, divided by the total
};

/// Of the numbers 0, 1, 2, ... with these weights; all zero if the weights are.
template <class Weight>
Moments moments_of(std::span<const Weight> weights) {
    Moments moments;
    double sum = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const auto weight = static_cast<double>(weights[i]);
        moments.total += weight;
        sum += weight * static_cast<double>(i);
    }
    if (!(moments.total > 0.0)) return {};
    moments.mean = sum / moments.total;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double off = static_cast<double>(i) - moments.mean;
        moments.variance += static_cast<double>(weights[i]) * off * off / moments.total;
    }
    return moments;
}

}  // namespace carom
