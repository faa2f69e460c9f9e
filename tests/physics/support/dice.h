#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

/// Random numbers for scenes of tests, the same on every machine (splitmix64).
struct Dice {
    std::uint64_t state;

    double next() {
        state += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        z ^= z >> 31;
        return static_cast<double>(z >> 11) / 9007199254740992.0;
    }
    double between(double low, double high) { return low + (high - low) * next(); }
    /// Evenly over magnitudes.
    double scaled(double low, double high) { return low * std::pow(high / low, next()); }
    int below(int count) { return std::min(count - 1, static_cast<int>(next() * count)); }
    bool chance(double share) { return next() < share; }
};
