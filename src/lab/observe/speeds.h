#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "lab/observe/curve.h"
#include "physics/world/world.h"

namespace carom {

/// The distribution of speeds against that of Maxwell and Boltzmann in two dimensions.
///
/// The unit of a ball's speed is the root mean square speed of a ball of its mass in equilibrium,
/// sqrt(2 kT / m), with kT the present mean of m v^2 / 2. So u = v sqrt(m / 2kT) is 2 u exp(-u^2)
/// distributed in equilibrium, whatever the masses; for equal masses u is v by the root mean square
/// speed. No value if no ball moves.
class SpeedMeter {
  public:
    static constexpr double bin_width = 0.05;
    static constexpr std::size_t bins = 80;

    void note_tick(const World& world);

    /// The density of u over all ticks of the observation, by the middle of bins up to u = 4, with
    /// the expected one. Empty before the first tick with a moving ball.
    Curve curve() const;

  private:
    std::array<std::uint64_t, bins> counts_{};
    std::uint64_t total_ = 0;
};

/// The Kolmogorov-Smirnov distance of the present u from 1 - exp(-u^2), 0 to 1. For n balls in
/// equilibrium it is below 1.36 / sqrt(n) with a probability of 95 %.
std::optional<double> speed_distance(const World& world);

/// The kurtosis <u^4> / <u^2>^2 of the present speeds: 2 in equilibrium, 1 if all balls have the
/// same energy, more if few have most of it.
std::optional<double> speed_kurtosis(const World& world);

}  // namespace carom
