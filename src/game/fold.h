#pragma once

#include <bit>
#include <cstdint>

#include "geometry/vec2.h"
#include "physics/world/random.h"

namespace carom {

/// Folds numbers into one, in order: for fingerprints of what a game remembers.
class Fold {
  public:
    explicit Fold(std::uint64_t start) : state_(start) {}
    void add(std::uint64_t value) { state_ = random_bits(state_, RandomStream::level, value, 0); }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    void add(const Vec2& v) {
        add(v.x);
        add(v.y);
    }
    std::uint64_t state() const { return state_; }

  private:
    std::uint64_t state_;
};

}  // namespace carom
