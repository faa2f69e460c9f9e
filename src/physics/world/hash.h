#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "geometry/shapes.h"
#include "physics/world/ids.h"

namespace carom {

/// Combines numbers into 64 bits, in order and bit by bit: -0 and 0 differ. Each step is a
/// bijection of the state, so no number that was added can be lost.
class Hash {
  public:
    void add(std::uint64_t word) {
        state_ = (state_ ^ word) * 0x9fb21c651e98df25u;
        state_ ^= state_ >> 32;
    }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    void add(Vec2 v) {
        add(v.x);
        add(v.y);
    }
    void add(const Capsule& c) {
        add(c.start);
        add(c.end);
        add(c.radius);
    }
    void add(const Box& box) {
        add(box.low);
        add(box.high);
    }
    void add(BallId id) { add(std::uint64_t{number(id)}); }
    void add(CapsuleId id) { add(std::uint64_t{number(id)}); }
    /// Integers, flags and enumerations; a negative number counts as its 64-bit pattern.
    template <typename Value>
    requires std::is_integral_v<Value> || std::is_enum_v<Value>
    void add(Value value) { add(static_cast<std::uint64_t>(value)); }
    template <typename Value>
    void add(const std::optional<Value>& value) {
        add(value.has_value());
        if (value) add(*value);
    }
    /// All of a list, with its length.
    template <typename List>
    requires requires(const List& list) { list.begin() != list.end(); }
    void add(const List& list) {
        add(std::uint64_t{list.size()});
        for (const auto& value : list)
            add(value);
    }

    std::uint64_t state() const { return state_; }

  private:
    std::uint64_t state_ = 0x243f6a8885a308d3u;
};

}  // namespace carom
