#include "physics/flight.h"

#include "geometry/closest.h"
#include "geometry/elementary.h"

namespace carom {

Flight flight_over(const Model& model, double duration) {
    const double drag = model.drag.value_or(0.0) * duration;
    const Vec2 gravity = model.gravity.value_or(Vec2{});
    const double mean = mean_decay(drag);
    return {.duration = duration,
            .decay = model.drag ? exponential(-drag) : 1.0,
            .travel_per_velocity = duration * mean,
            .velocity_from_rest = gravity * (duration * mean),
            .travel_from_rest = gravity * (duration * duration * mean_decay_ramp(drag))};
}

Vec2 limited(Vec2 velocity, double limit) {
    if (length_squared(velocity) <= limit * limit) return velocity;
    return direction(velocity, {}) * limit;
}

}  // namespace carom
