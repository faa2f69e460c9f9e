#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <string_view>

#include "physics/world/world.h"

/// What the fuzzers share. Each reads bytes of libFuzzer as one kind of input; scripts/fuzz builds
/// and runs them.
namespace carom::fuzz {

inline void check(bool holds) {
    if (!holds) std::abort();
}

inline std::string_view text_of(const std::uint8_t* bytes, std::size_t size) {
    return {reinterpret_cast<const char*>(bytes), size};
}

/// The world is small enough to be simulated for each of thousands of inputs.
inline bool is_small(const World& world) {
    return world.balls().size() <= 50 && world.capsules().size() <= 200 &&
           world.emitters().size() <= 10;
}

/// Ends ticks that need too much work. It counts calls, not time, so a run can be repeated.
inline std::function<bool()> work_budget() {
    return [left = 2000]() mutable { return --left > 0; };
}

}  // namespace carom::fuzz
