#include "geometry/elementary.h"
#include "physics/event/motion/edge_impact.h"

// Kinematic edges, and the edges of seesaws.
namespace carom {

template <typename Real>
Edge<Real> MovingEdge<Real>::at(const Real& when) const {
    const Real since = lesser(when, stop) - time;
    Edge<Real> moved = edge;
    if (is_hinged) {
        const SinCos turn = sin_cos(static_cast<double>(rate * since));
        for (Vector<Real>* const end : {&moved.start, &moved.end}) {
            const Vector<Real> arm = *end - pivot;
            *end = pivot + arm * Real(turn.cos) + perpendicular(arm) * Real(turn.sin);
        }
        return moved;
    }
    moved.start += start_velocity * since;
    moved.end += end_velocity * since;
    return moved;
}

namespace {

// The edge of a seesaw, which turns. As seen from it, the ball's acceleration is its own, the
// Coriolis and the centrifugal one: a - 2 w x v + w x (w x r), with the velocity v as seen from the
// hinge.
template <typename Real>
std::optional<Real> hinged_edge_time_of_impact(const Trajectory<Real>& trajectory,
                                               const MovingEdge<Real>& edge, const Real& radius,
                                               const Field<Real>& field, const Real& begin,
                                               const Real& last, ToiSearch<Real>& search) {
    const BallState<Real> now = state_at(trajectory, field, begin);
    const Real ours = most_acceleration(trajectory, field, begin);
    const Real turning = absolute(edge.rate);
    const Real fastest = length(now.velocity) + ours * (last - begin);
    const Real furthest = length(now.position - edge.pivot) + fastest * (last - begin);
    const Real bound = ours + turning * (Real(2.0) * fastest + turning * furthest);
    const auto separation_at = [&](const Real& time) -> Separation<Real> {
        const BallState<Real> state = state_at(trajectory, field, time);
        const Edge<Real> shape = edge.at(time);
        const auto contact = contact_with(shape, state.position, radius);
        const Vector<Real> foot = shape.start + (shape.end - shape.start) * contact.place;
        const Vector<Real> surface = perpendicular(foot - edge.pivot) * edge.rate;
        Separation<Real> found{contact.gap, dot(contact.normal, state.velocity - surface), Real{}};
        const Vector<Real> arm = state.position - edge.pivot;
        found.normal_acceleration =
            dot(contact.normal, acceleration_at(trajectory, field, state.velocity) -
                                    perpendicular(state.velocity) * (Real(2.0) * edge.rate) -
                                    arm * (edge.rate * edge.rate));
        return found;
    };
    auto limits = tolerance(now.position, radius, length(now.velocity) + turning * furthest, Real{},
                            radius, field.pressing);
    // A ball that lies on the edge hops as high as one that lies on a moving ball.
    limits.rest_height =
        Real(2.0 * (field.pressing > Real{} ? moving_rest_height : rest_height)) * radius;
    return first_time_of_impact<Real>(separation_at, begin, last, bound,
                                      weighed(limits, trajectory, field), search);
}

}  // namespace

template <typename Real>
std::optional<Real> moving_edge_time_of_impact(const Trajectory<Real>& trajectory,
                                               const MovingEdge<Real>& edge, const Real& radius,
                                               const Field<Real>& field, const Real& begin,
                                               const Real& end, ToiSearch<Real>& search) {
    const Real last = end_of_search(trajectory, field, end);
    if (edge.is_hinged)
        return hinged_edge_time_of_impact(trajectory, edge, radius, field, begin, last, search);
    const bool moves = begin < edge.stop;
    const Vector<Real> from = moves ? edge.start_velocity : Vector<Real>{};
    const Vector<Real> to = moves ? edge.end_velocity : Vector<Real>{};
    const Edge<Real> shape = edge.at(begin);
    const Real whole = length(shape.end - shape.start);
    const BallState<Real> now = state_at(trajectory, field, begin);
    const Real speed = length(now.velocity) + greater(length(from), length(to));
    const Real ours = most_acceleration(trajectory, field, begin);
    const Real zero{};
    Real bound = ours;     // of the search
    Real pressing = ours;  // what may press the bodies together, for tolerances
    if (whole > zero) {
        const Real turning = Real(2.0) * length(to - from) / whole;
        const Real fastest = speed + ours * (last - begin);
        const Real away = contact_with(shape, now.position, zero).gap + shape.radius;
        const Real furthest = away + fastest * (last - begin);
        bound += turning * (Real(2.0) * fastest + turning * furthest);
        pressing += turning * (Real(2.0) * fastest + turning * whole);
    }
    const auto separation_at = [&](const Real& time) -> Separation<Real> {
        const BallState<Real> state = state_at(trajectory, field, time);
        const auto contact = contact_with(edge.at(time), state.position, radius);
        const Vector<Real> surface = from + (to - from) * contact.place;
        return {contact.gap, dot(contact.normal, state.velocity - surface), zero};
    };
    auto limits = tolerance(now.position, radius, speed, pressing, radius, field.pressing,
                            is_on_cloth(trajectory) ? moving_rest_height : rest_height);
    return first_time_of_impact<Real>(separation_at, begin, last, bound,
                                      weighed(limits, trajectory, field), search);
}

#define CAROM_FOR(Real)                                                                    \
    template Edge<Real> MovingEdge<Real>::at(const Real&) const;                           \
    template std::optional<Real> moving_edge_time_of_impact(                               \
        const Trajectory<Real>&, const MovingEdge<Real>&, const Real&, const Field<Real>&, \
        const Real&, const Real&, ToiSearch<Real>&);
CAROM_FOR(double)
CAROM_FOR(DoubleDouble)
#undef CAROM_FOR

}  // namespace carom
