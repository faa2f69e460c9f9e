#include "lab/measure/pareto.h"

#include <cmath>
#include <utility>

namespace carom {
namespace {

bool is_usable(const Tradeoff& choice) {
    return std::isfinite(choice.cost) && std::isfinite(choice.fault);
}

bool dominates(const Tradeoff& a, const Tradeoff& b) {
    return a.cost <= b.cost && a.fault <= b.fault && (a.cost < b.cost || a.fault < b.fault);
}

// The first choice with the lowest `rank` among the `allowed` ones.
template <class Allowed, class Rank>
std::optional<std::size_t> best(std::span<const Tradeoff> choices, Allowed allowed, Rank rank) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (!is_usable(choices[i]) || !allowed(choices[i])) continue;
        if (!found || rank(choices[i]) < rank(choices[*found])) found = i;
    }
    return found;
}

}  // namespace

std::vector<bool> pareto_front(std::span<const Tradeoff> choices) {
    std::vector<bool> front(choices.size(), false);
    for (std::size_t i = 0; i < choices.size(); ++i) {
        front[i] = is_usable(choices[i]);
        for (std::size_t j = 0; j < choices.size() && front[i]; ++j) {
            const bool is_duplicate = j < i && front[j] && choices[j].cost == choices[i].cost &&
                                      choices[j].fault == choices[i].fault;
            if (is_duplicate || (is_usable(choices[j]) && dominates(choices[j], choices[i])))
                front[i] = false;
        }
    }
    return front;
}

std::optional<std::size_t> best_within(std::span<const Tradeoff> choices, double budget) {
    return best(
        choices, [&](const Tradeoff& choice) { return choice.cost <= budget; },
        [](const Tradeoff& choice) { return std::pair(choice.fault, choice.cost); });
}

std::optional<std::size_t> cheapest_within(std::span<const Tradeoff> choices, double most) {
    return best(
        choices, [&](const Tradeoff& choice) { return choice.fault <= most; },
        [](const Tradeoff& choice) { return std::pair(choice.cost, choice.fault); });
}

}  // namespace carom
