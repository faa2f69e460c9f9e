#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/elementary.h"

/// The random numbers of fuzzed scenes: SplitMix64, equal on every machine for a given seed. A
/// caller draws at most one number in an operand of + or in an argument: compilers evaluate these
/// in different orders (see Line in level_draft.h).
namespace carom::bits {

class Random {
  public:
    // Otherwise neighbouring seeds would draw shifted copies of one sequence.
    explicit Random(std::uint64_t seed) : state_(seed) { state_ = bits() ^ 0x5851f42d4c957f2du; }

    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// Uniform in [low, high).
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
    }
    /// Log-uniform: ten to the power of a uniform number between `low` and `high`.
    double decades(double low, double high) {
        constexpr double log_of_10 = 2.302585092994045684;
        return exponential(log_of_10 * between(low, high));
    }
    /// One of low, low + 1, ..., high.
    int integer(int low, int high) {
        return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
    }
    bool chance(double probability) { return between(0.0, 1.0) < probability; }
    template <typename T, std::size_t count>
    const T& one_of(const T (&choices)[count]) {
        return choices[bits() % count];
    }

  private:
    std::uint64_t state_;
};

}  // namespace carom::bits
