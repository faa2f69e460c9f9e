#include "physics/event/motion/ball_impact.h"

namespace carom {

template <typename Real>
std::optional<Real> ball_time_of_impact(const Trajectory<Real>& a, const Trajectory<Real>& b,
                                        const Vector<Real>& shift, const Real& reach,
                                        const Real& small, const Field<Real>& field,
                                        const Real& end, ToiSearch<Real>& search) {
    if (is_parabola(a, field) && is_parabola(b, field) && a.acceleration == b.acceleration) {
        const auto time = straight_time_of_impact(a, b, a.acceleration, shift, reach, small, field);
        return time && *time <= end ? time : std::nullopt;
    }
    const Real begin = greater(a.time, b.time);
    const Real last = lesser(end_of_search(a, field, end), end_of_search(b, field, end));
    if (last < begin) return std::nullopt;
    Real bound = most_acceleration(a, field, begin) + most_acceleration(b, field, begin);
    if (is_parabola(a, field) && is_parabola(b, field))
        bound = length(a.acceleration - b.acceleration);
    const auto separation_at = [&](const Real& time) {
        const BallState<Real> at_a = state_at(a, field, time);
        const BallState<Real> at_b = state_at(b, field, time);
        const Vector<Real> acceleration =
            acceleration_at(a, field, at_a.velocity) - acceleration_at(b, field, at_b.velocity);
        return lasting_bound(separation_of(at_a.position - at_b.position - shift,
                                           at_a.velocity - at_b.velocity, acceleration, reach),
                             acceleration,
                             a.motion == Motion::turning || b.motion == Motion::turning,
                             field.has_drag);
    };
    // With the sum of both, balls that fly together under drag would count as pressed together, and
    // a slow approach as none.
    if (field.has_drag && a.motion != Motion::turning && b.motion != Motion::turning)
        bound = separation_at(begin).acceleration_bound;
    const bool one_rests = a.motion == Motion::resting || b.motion == Motion::resting;
    const bool on_cloth = is_on_cloth(a) || is_on_cloth(b);
    const double height =
        on_cloth ? unpressed_rest_height : (one_rests ? rest_height : moving_rest_height);
    const Real speeds = length(a.velocity) + length(b.velocity);
    auto limits = tolerance(a.position, reach, speeds, bound, small, field.pressing, height);
    const bool is_kinematic = a.motion == Motion::held || b.motion == Motion::held;
    if (on_cloth) {
        limits.rest_height =
            Real(2.0 * (is_kinematic ? moving_rest_height : cloth_rest_height)) * small;
    } else {
        limits.sink_depth = Real(height) * small;
        limits.sink_speed = rounding_of_approach(speeds, small, field.pressing);
    }
    return first_time_of_impact<Real>(separation_at, begin, last, bound,
                                      weighed(weighed(limits, a, field), b, field), search);
}

#define CAROM_FOR(Real)                                                                     \
    template std::optional<Real> ball_time_of_impact(                                       \
        const Trajectory<Real>&, const Trajectory<Real>&, const Vector<Real>&, const Real&, \
        const Real&, const Field<Real>&, const Real&, ToiSearch<Real>&);
CAROM_FOR(double)
CAROM_FOR(DoubleDouble)
#undef CAROM_FOR

}  // namespace carom
