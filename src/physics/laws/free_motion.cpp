#include "physics/laws/free_motion.h"

#include "geometry/closest.h"
#include "geometry/elementary.h"

namespace carom {

Flight flight_with_drag(double drag, double duration) {
    const double exponent = drag * duration;
    const double mean = duration * mean_decay(exponent);
    return {.duration = duration,
            .decay = exponential(-exponent),
            .travel_per_velocity = mean,
            .travel_per_gravity = duration * duration * mean_decay_ramp(exponent),
            .velocity_per_gravity = mean};
}

Vec2 limited(Vec2 velocity, double limit) {
    if (length_squared(velocity) <= limit * limit) return velocity;
    return direction(velocity, {}) * limit;
}

}  // namespace carom
