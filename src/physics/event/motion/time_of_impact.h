#pragma once

#include <algorithm>

#include "geometry/conservative_advancement.h"
#include "physics/event/motion/tolerances.h"
#include "physics/event/motion/trajectory.h"

/// The time of impact of two trajectories (ball_impact.h), or of a trajectory and an edge
/// (edge_impact.h): when they first touch and approach. geometry/conservative_advancement.h says
/// what counts as an impact, and README.md why none is missed.
///
/// All times are absolute, s; `end` is the horizon of the search. Each function gives the same bits
/// whenever it is asked, since it starts from the trajectories alone; only that for a kinematic
/// edge starts at a time that it is given. Closed form: two balls with the same constant
/// acceleration, a parabola and the side of an edge, a straight line and a round end. Everything
/// else takes a search of a few iterations: a parabola and a round end, two different
/// accelerations, turning, drag, an edge along which the ball slides or in which it starts, and
/// kinematic edges.
///
/// The bound A of a search (README.md derives it): the sum of both balls' `most_acceleration`, of
/// two parabolas the length of their relative acceleration, for a fixed edge that of the ball. For
/// a kinematic edge see edge_impact.h.
///
/// Here is what both share: tolerances, and the separation of two points with its bounds.
namespace carom {

/// The rounding of a gap measured at this position, length: gaps up to this are contacts.
template <typename Real>
inline Real rounding_at(const Vector<Real>& position, const Real& reach) {
    return Real(4.0 * precision<Real>) * (absolute(position.x) + absolute(position.y) + reach);
}

template <typename Real>
const Real& lesser(const Real& a, const Real& b) {
    return b < a ? b : a;
}
template <typename Real>
const Real& greater(const Real& a, const Real& b) {
    return a < b ? b : a;
}

/// Approaches below this are rounding, length/s. Parameters: see `tolerance`.
template <typename Real>
Real rounding_of_approach(const Real& speeds, const Real& small, const Real& pressing) {
    return Real(approach_rounding<Real>) * speeds +
           Real(pressed_rounding) * square_root(pressing * small) + Real(least_approach);
}

/// Which gaps and approaches count as touching and resting. `speeds` is the sum of both bodies'
/// speeds, `bound` that of their accelerations, `small` the smaller radius, `pressing` that of the
/// Field, `height` one of the rest heights of tolerances.h.
template <typename Real>
[[gnu::always_inline]] inline ToiTolerance<Real> tolerance(const Vector<Real>& position,
                                                           const Real& reach, const Real& speeds,
                                                           const Real& bound, const Real& small,
                                                           const Real& pressing,
                                                           double height = rest_height) {
    const Real rounding = rounding_of_approach(speeds, small, pressing);
    const Real rest_speed =
        bound > Real{} ? square_root(Real(2.0 * height) * bound * small) : Real{};
    return {rounding_at(position, reach), greater(rounding, rest_speed)};
}

/// These tolerances for a search along this trajectory. An iteration about a ball that turns, or
/// that drag slows, counts as more work, since its position is a series or an exponential.
template <typename Real>
ToiTolerance<Real> weighed(ToiTolerance<Real> limits, const Trajectory<Real>& trajectory,
                           const Field<Real>& field) {
    if (trajectory.motion == Motion::turning)
        limits.weight = turning_iteration;
    else if (!is_parabola(trajectory, field))
        limits.weight = std::max(limits.weight, drag_iteration);
    return limits;
}

/// The separation of two points at `offset` from one another, with the sum of the radii `reach`.
/// Where the points coincide, only the distance is set.
template <typename Real>
Separation<Real> separation_of(const Vector<Real>& offset, const Vector<Real>& velocity,
                               const Vector<Real>& acceleration, const Real& reach) {
    const Real away = length(offset);
    if (!(away > Real{})) return {-reach, Real{}, Real{}, Real{}, Real{}, Real{}};
    const Vector<Real> normal = offset / away;
    const Real rate = dot(normal, velocity);
    const Real across = cross(normal, velocity);
    const Real normal_acceleration = dot(normal, acceleration);
    return {
        away - reach,     rate, across * across / away + normal_acceleration, normal_acceleration,
        length(velocity), away};
}

/// Adds what will hold from now on. Under drag all accelerations decay at the same rate: bodies
/// will never be pressed together more strongly than now. The acceleration of a turn predicts
/// nothing.
template <typename Real>
Separation<Real> lasting_bound(Separation<Real> now, const Vector<Real>& acceleration, bool turns,
                               bool has_drag) {
    if (turns) {
        now.center_distance = Real{};
    } else if (has_drag) {
        now.acceleration_bound = length(acceleration);
        if (Real{} < now.normal_acceleration) now.normal_acceleration = Real{};
    }
    return now;
}

/// The acceleration of a ball with this velocity; 0 in a turn, where `most_acceleration` bounds it.
template <typename Real>
Vector<Real> acceleration_at(const Trajectory<Real>& trajectory, const Field<Real>& field,
                             const Vector<Real>& velocity) {
    if (trajectory.motion == Motion::turning) return {};
    if (!field.has_drag || trajectory.motion == Motion::held) return trajectory.acceleration;
    return trajectory.acceleration - velocity * field.drag;
}

/// `end`, but no later than the trajectory's piece: a search stops where the trajectory does.
template <typename Real>
Real end_of_search(const Trajectory<Real>& trajectory, const Field<Real>& field, const Real& end) {
    return trajectory.motion == Motion::turning ? lesser(end, piece_end(trajectory, field)) : end;
}

}  // namespace carom
