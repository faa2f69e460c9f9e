#include "level/scene/quantities.h"

#include <array>

namespace carom {
namespace {

constexpr std::array<std::string_view, 25> names{"collisions",
                                                 "ball_ball",
                                                 "ball_edge",
                                                 "kinetic_energy",
                                                 "potential_energy",
                                                 "energy",
                                                 "momentum_x",
                                                 "momentum_y",
                                                 "angular_momentum",
                                                 "time",
                                                 "escaped",
                                                 "overlap",
                                                 "balls",
                                                 "removed",
                                                 "x",
                                                 "y",
                                                 "vx",
                                                 "vy",
                                                 "speed",
                                                 "w",
                                                 "count",
                                                 "mean",
                                                 "variance",
                                                 "variance_ratio",
                                                 "chi_square"};

}  // namespace

bool is_of_ball(QuantityKind kind) {
    return kind >= QuantityKind::x && kind <= QuantityKind::w;
}

bool is_of_bins(QuantityKind kind) {
    return kind >= QuantityKind::count;
}

std::string_view name(QuantityKind kind) {
    return names[static_cast<std::size_t>(kind)];
}

std::vector<QuantityKind> quantity_kinds() {
    std::vector<QuantityKind> kinds;
    for (std::size_t i = 0; i < names.size(); ++i)
        kinds.push_back(static_cast<QuantityKind>(i));
    return kinds;
}

std::vector<double> binomial_shares(int n, double p) {
    std::vector<double> shares(static_cast<std::size_t>(n) + 1, 0.0);
    if (p <= 0.0 || p >= 1.0) {
        (p <= 0.0 ? shares.front() : shares.back()) = 1.0;
        return shares;
    }
    const auto likeliest = static_cast<std::size_t>(static_cast<double>(n) * p);
    const double odds = p / (1.0 - p);
    shares[likeliest] = 1.0;
    double sum = 1.0;
    const auto tosses = static_cast<std::size_t>(n);
    for (std::size_t k = likeliest; k < tosses; ++k) {
        shares[k + 1] =
            shares[k] * odds * static_cast<double>(tosses - k) / static_cast<double>(k + 1);
        sum += shares[k + 1];
    }
    for (std::size_t k = likeliest; k > 0; --k) {
        shares[k - 1] =
            shares[k] / odds * static_cast<double>(k) / static_cast<double>(tosses - k + 1);
        sum += shares[k - 1];
    }
    for (double& share : shares)
        share /= sum;
    return shares;
}

}  // namespace carom
