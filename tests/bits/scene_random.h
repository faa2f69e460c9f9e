#pragma once

#include <cmath>
#include <cstdint>
#include <span>

/// The random numbers of fuzzed scenes: SplitMix64, equal on every machine for a given seed.
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
    double decades(double low, double high) { return std::pow(10.0, between(low, high)); }
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
