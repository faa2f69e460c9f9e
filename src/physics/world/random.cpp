#include "physics/world/random.h"

namespace carom {
namespace {

// The finaliser of SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators,
// 2014).
std::uint64_t mix(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

}  // namespace

std::uint64_t random_bits(std::uint64_t seed, RandomStream stream, std::uint64_t who,
                          std::uint64_t index) {
    return mix(index + mix(who + mix(static_cast<std::uint64_t>(stream) + mix(seed))));
}

double random_unit(std::uint64_t seed, RandomStream stream, std::uint64_t who,
                   std::uint64_t index) {
    return static_cast<double>(random_bits(seed, stream, who, index) >> 11) * 0x1p-53;
}

double random_between(double low, double high, std::uint64_t seed, RandomStream stream,
                      std::uint64_t who, std::uint64_t index) {
    return low + (high - low) * random_unit(seed, stream, who, index);
}

}  // namespace carom
