#pragma once

#include <optional>

#include "physics/laws/free_motion.h"

/// The straight path of a ball within a substep, along which impacts are predicted: for the solvers
/// `swept` and `contact`.
namespace carom {

/// A point that moves uniformly. Times are seconds since the substep began.
struct Chord {
    Vec2 position;      ///< at `time`
    Vec2 velocity{};    ///< length/s
    double time = 0.0;  ///< s

    Vec2 position_at(double now) const { return position + velocity * (now - time); }
};

/// Velocity along the chord of free flight: from where a ball is with `velocity` to where gravity
/// and drag take it in `left` s. Where no time is left: `velocity`.
inline Vec2 chord_velocity(std::optional<double> drag, Vec2 velocity, Vec2 gravity, double left) {
    return left > 0.0 ? travel(flight_over(drag, left), velocity, gravity) / left : velocity;
}

}  // namespace carom
