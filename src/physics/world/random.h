#pragma once

#include <cstdint>

/// Random numbers that are a function of what they are for, not of how many were drawn before: no
/// state, so nothing to save, and no order of events that could change them.
namespace carom {

/// Who draws. Each purpose has numbers of its own.
enum class RandomStream : std::uint32_t {
    emitter = 1,
    fill = 2,
    scatter = 3,
    rack = 4,
    player = 5,
    level = 6,
    lab = 7
};

/// 64 uniform bits for the `index`th draw of `who` (an id) in `stream`.
std::uint64_t random_bits(std::uint64_t seed, RandomStream stream, std::uint64_t who,
                          std::uint64_t index);

/// Uniform in [0, 1), a multiple of 2^-53.
double random_unit(std::uint64_t seed, RandomStream stream, std::uint64_t who, std::uint64_t index);

/// Uniform in [low, high). Pre: low <= high, both finite.
double random_between(double low, double high, std::uint64_t seed, RandomStream stream,
                      std::uint64_t who, std::uint64_t index);

}  // namespace carom
