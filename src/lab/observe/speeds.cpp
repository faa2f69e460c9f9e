#include "lab/observe/speeds.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace carom {
namespace {

// u^2 of all balls; empty if none moves.
std::vector<double> reduced_squares(const World& world) {
    const Balls& balls = world.balls();
    std::vector<double> squares;
    double sum = 0.0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        squares.push_back(length_squared(balls.velocity[i]) / balls.inverse_mass[i]);
        sum += squares.back();
    }
    if (!(sum > 0.0) || !std::isfinite(sum)) return {};
    const double mean = sum / static_cast<double>(squares.size());
    for (double& square : squares)
        square /= mean;
    return squares;
}

}  // namespace

void SpeedMeter::note_tick(const World& world) {
    for (const double square : reduced_squares(world)) {
        const double bin = std::sqrt(square) / bin_width;
        if (bin < static_cast<double>(bins)) ++counts_[static_cast<std::size_t>(bin)];
        ++total_;
    }
}

Curve SpeedMeter::curve() const {
    Curve curve{"u", {}};
    if (total_ == 0) return curve;
    for (std::size_t i = 0; i < bins; ++i) {
        const double low = static_cast<double>(i) * bin_width;
        const double high = low + bin_width;
        const double share = static_cast<double>(counts_[i]) / static_cast<double>(total_);
        const double expected = std::exp(-low * low) - std::exp(-high * high);
        curve.points.push_back({(low + high) / 2.0, share / bin_width, expected / bin_width});
    }
    return curve;
}

std::optional<double> speed_distance(const World& world) {
    std::vector<double> squares = reduced_squares(world);
    if (squares.empty()) return std::nullopt;
    std::ranges::sort(squares);
    const auto count = static_cast<double>(squares.size());
    double distance = 0.0;
    for (std::size_t i = 0; i < squares.size(); ++i) {
        const double expected = -std::expm1(-squares[i]);
        distance = std::max({distance, expected - static_cast<double>(i) / count,
                             static_cast<double>(i + 1) / count - expected});
    }
    return distance;
}

std::optional<double> speed_kurtosis(const World& world) {
    const std::vector<double> squares = reduced_squares(world);
    if (squares.empty()) return std::nullopt;
    double sum = 0.0;
    for (const double square : squares)
        sum += square * square;
    return sum / static_cast<double>(squares.size());
}

}  // namespace carom
