#pragma once

#include "physics/world/model.h"

/// Free motion: what gravity and drag do to a ball without contacts. Exact for a step of any
/// length.
namespace carom {

/// The solution over one step of `duration` seconds, which is linear in velocity and gravity:
///     travel   = velocity * travel_per_velocity + gravity * travel_per_gravity
///     velocity = velocity * decay + gravity * velocity_per_gravity
/// Source: the solution of dv/dt = g - k v.
struct Flight {
    double duration = 0.0;
    double decay = 1.0;
    double travel_per_velocity = 0.0;   ///< s
    double travel_per_gravity = 0.0;    ///< s^2
    double velocity_per_gravity = 0.0;  ///< s
};

/// `drag` in 1/s. Pre: duration >= 0.
Flight flight_with_drag(double drag, double duration);

/// `drag` in 1/s; none: only gravity acts. Pre: duration >= 0.
inline Flight flight_over(std::optional<double> drag, double duration) {
    if (drag) return flight_with_drag(*drag, duration);
    return {.duration = duration,
            .decay = 1.0,
            .travel_per_velocity = duration,
            .travel_per_gravity = 0.5 * duration * duration,
            .velocity_per_gravity = duration};
}

/// Displacement over the step, length.
inline Vec2 travel(const Flight& flight, Vec2 velocity, Vec2 gravity) {
    return velocity * flight.travel_per_velocity + gravity * flight.travel_per_gravity;
}

/// Velocity at the end of the step, length/s.
inline Vec2 velocity_after(const Flight& flight, Vec2 velocity, Vec2 gravity) {
    return velocity * flight.decay + gravity * flight.velocity_per_gravity;
}

/// `velocity`, shortened to the speed `limit` (length/s) if it is faster.
Vec2 limited(Vec2 velocity, double limit);

}  // namespace carom
