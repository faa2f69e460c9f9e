#pragma once

#include "physics/model.h"

/// Free motion: what gravity and drag do to a ball that meets nothing. Exact for any length of
/// step.
namespace carom {

/// The motion over one step of `duration` seconds is linear in the velocity, so four numbers hold
/// it:
///     travel   = velocity * travel_per_velocity + travel_from_rest
///     velocity = velocity * decay + velocity_from_rest
/// Source: the solution of dv/dt = g - k v.
struct Flight {
    double duration = 0.0;
    double decay = 1.0;
    double travel_per_velocity = 0.0;  ///< s
    Vec2 velocity_from_rest;           ///< length/s
    Vec2 travel_from_rest;             ///< length
};

/// Pre: duration >= 0.
Flight flight_over(const Model& model, double duration);

inline Vec2 travel(const Flight& flight, Vec2 velocity) {
    return velocity * flight.travel_per_velocity + flight.travel_from_rest;
}

inline Vec2 velocity_after(const Flight& flight, Vec2 velocity) {
    return velocity * flight.decay + flight.velocity_from_rest;
}

/// `velocity`, no longer than `limit`.
Vec2 limited(Vec2 velocity, double limit);

}  // namespace carom
