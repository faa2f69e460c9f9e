#pragma once

#include <bit>
#include <cstdint>

#include "geometry/vec2.h"
#include "physics/world/random.h"

namespace carom {

/// A hash combiner: combines numbers, in order, into one of 64 bits, for fingerprints of a game's
/// state. Doubles are hashed by their bits, so 0 and -0 differ.
class Digest {
  public:
    explicit Digest(std::uint64_t start) : value_(start) {}
    void add(std::uint64_t value) { value_ = random_bits(value_, RandomStream::level, value, 0); }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    void add(const Vec2& v) {
        add(v.x);
        add(v.y);
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_;
};

}  // namespace carom
