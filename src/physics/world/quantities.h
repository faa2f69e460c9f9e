#pragma once

#include <cmath>

#include "geometry/vec2.h"

/// The quantities that a world may be given, by a level, a command or a recording. Beyond these
/// bounds, squares and fourth powers in the physics would overflow or underflow.
namespace carom {

/// Of every quantity, in the units of the world.
inline constexpr double largest_quantity = 1e18;
/// Of quantities that must be above 0, such as a radius or a mass.
inline constexpr double smallest_positive = 1e-18;

/// False for what is not a number, too.
inline bool is_quantity(double value) {
    return std::abs(value) <= largest_quantity;
}
inline bool is_quantity(Vec2 value) {
    return is_quantity(value.x) && is_quantity(value.y);
}
inline bool is_positive_quantity(double value) {
    return value >= smallest_positive && value <= largest_quantity;
}

}  // namespace carom
