#include "level/scene/quantities.h"

#include <algorithm>
#include <array>

namespace carom {
namespace {

using enum QuantityScope;

// Energies, momenta and angular momentum are sums over all balls. The potential energy is 0 at the
// origin; the angular momentum is about the origin.
constexpr std::array<QuantityRow, 25> rows{{
    {"collisions", world},  // of balls with balls and with edges
    {"ball_ball", world},
    {"ball_edge", world},
    {"kinetic_energy", world},
    {"potential_energy", world},
    {"energy", world},
    {"momentum_x", world},
    {"momentum_y", world},
    {"angular_momentum", world},
    {"time", world},     // s since the start
    {"escaped", run},    // balls outside the closed outline in which they started
    {"overlap", run},    // the deepest at the end of any tick, a length
    {"balls", world},    // balls that exist
    {"removed", world},  // balls that have been removed
    {"x", ball},
    {"y", ball},
    {"vx", ball},
    {"vy", ball},
    {"speed", ball},
    {"w", ball},               // spin, rad/s, counter-clockwise; 0 in a model without spin
    {"count", bins},           // balls in all bins
    {"mean", bins},            // of the bin numbers
    {"variance", bins},        // of the bin numbers (divided by the count)
    {"variance_ratio", bins},  // variance over that of the expected shares
    {"chi_square", bins},      // sum of (counted - expected)^2 / expected over the bins
}};

}  // namespace

bool is_of_ball(QuantityKind kind) {
    return kind->scope == ball;
}

bool is_of_bins(QuantityKind kind) {
    return kind->scope == bins;
}

std::string_view name(QuantityKind kind) {
    return kind->name;
}

std::vector<QuantityKind> quantity_kinds() {
    std::vector<QuantityKind> kinds;
    for (const QuantityRow& row : rows)
        kinds.push_back(&row);
    return kinds;
}

QuantityKind quantity_named(std::string_view name) {
    const auto found = std::ranges::find(rows, name, &QuantityRow::name);
    return found == rows.end() ? nullptr : &*found;
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
