#include "physics/event/motion/edge_impact.h"

namespace carom {

template <typename Real>
EdgeContact<Real> contact_with(const Edge<Real>& edge, const Vector<Real>& position,
                               const Real& radius) {
    const Vector<Real> span = edge.end - edge.start;
    const Real square = length_squared(span);
    const Real zero{};
    const Real one(1.0);
    Real place{};
    if (square > zero) {
        place = dot(position - edge.start, span) / square;
        place = place < zero ? zero : (place > one ? one : place);
    }
    const Vector<Real> offset = position - (edge.start + span * place);
    const Real away = length(offset);
    Vector<Real> normal{zero, one};
    if (place > zero && place < one) {
        // Beside the spine.
        const Vector<Real> left = perpendicular(span) / square_root(square);
        normal = dot(left, offset) < zero ? -left : left;
    } else if (away > zero) {
        normal = offset / away;
    }
    return {away - radius - edge.radius, normal, place};
}

namespace {

// Time of impact with a fixed point, `reach` away from the ball's centre.
template <typename Real>
std::optional<Real> point_time_of_impact(const Trajectory<Real>& trajectory,
                                         const Vector<Real>& point, const Real& reach,
                                         const Real& small, const Field<Real>& field,
                                         const Real& end, ToiSearch<Real>& search) {
    // A ball that turns round this very point comes no nearer to it.
    if (trajectory.motion == Motion::turning && trajectory.center == point) return std::nullopt;
    const Real last = end_of_search(trajectory, field, end);
    const Real bound = most_acceleration(trajectory, field, trajectory.time);
    const auto limits = tolerance(trajectory.position, reach, length(trajectory.velocity), bound,
                                  small, field.pressing);
    if (!(bound > Real{}) && is_parabola(trajectory, field)) {
        const Vector<Real> offset = trajectory.position - point;
        const Real closing = -dot(offset, trajectory.velocity);
        if (!(closing > Real{})) return std::nullopt;
        const Separation<Real> now =
            separation_of(offset, trajectory.velocity, Vector<Real>{}, reach);
        if (now.distance <= limits.slop)
            return now.velocity < -limits.rest_speed ? std::optional<Real>(trajectory.time)
                                                     : std::nullopt;
        const Real speed_squared = length_squared(trajectory.velocity);
        const Real miss = cross(offset, trajectory.velocity);
        const Real discriminant = speed_squared * reach * reach - miss * miss;
        if (!(discriminant > Real{})) return std::nullopt;
        // Both terms of the denominator are positive, so nothing cancels.
        const Real time = trajectory.time + now.distance * (length(offset) + reach) /
                                                (closing + square_root(discriminant));
        return time <= end ? std::optional<Real>(time) : std::nullopt;
    }
    return first_time_of_impact<Real>(
        [&](const Real& time) {
            const BallState<Real> state = state_at(trajectory, field, time);
            const Vector<Real> acceleration = acceleration_at(trajectory, field, state.velocity);
            return lasting_bound(
                separation_of(state.position - point, state.velocity, acceleration, reach),
                acceleration, trajectory.motion == Motion::turning, field.has_drag);
        },
        trajectory.time, last, bound, weighed(limits, trajectory, field), search);
}

// Time of impact with the side of an edge to which `normal` points. It counts where the foot of the
// ball lies within the edge. `along` is the edge's unit direction, `whole` its length.
template <typename Real>
std::optional<Real> side_time_of_impact(const Trajectory<Real>& trajectory, const Edge<Real>& edge,
                                        const Vector<Real>& along, const Real& whole,
                                        const Vector<Real>& normal, const Real& radius,
                                        const Field<Real>& field, const Real& end,
                                        ToiSearch<Real>& search) {
    const Real reach = radius + edge.radius;
    const Vector<Real> offset = trajectory.position - edge.start;
    const Real height = dot(normal, offset);
    const Real rate = dot(normal, trajectory.velocity);
    const Real bend = dot(normal, trajectory.acceleration);
    const Real zero{};
    const auto is_beside = [&](const Real& time) {
        const Real place = dot(along, state_at(trajectory, field, time).position - edge.start);
        return place >= zero && place <= whole;
    };
    std::optional<Real> found;
    if (is_parabola(trajectory, field)) {
        auto limits = tolerance(trajectory.position, reach, length(trajectory.velocity),
                                bend < zero ? -bend : zero, radius, field.pressing);
        limits.slop += rounding_at(offset, reach);
        const Real gap = height - reach;
        if (!(gap < -limits.slop)) {
            const auto since = quadratic_time_of_impact<Real>({gap, rate, bend}, limits);
            if (since) found = trajectory.time + *since;
        } else {
            const bool overlaps = height > zero && is_beside(trajectory.time);
            if (overlaps && rate < -limits.rest_speed) return trajectory.time;
            if (!(bend < zero)) return std::nullopt;
            // The ball is below the side: it must rise above it and fall again.
            const Real discriminant = rate * rate - Real(2.0) * bend * gap;
            if (rate > zero && discriminant > zero)
                found = trajectory.time + (rate + square_root(discriminant)) / -bend;
            else if (overlaps)
                found = trajectory.time + (rate + limits.rest_speed) / -bend;
        }
    } else {
        const Real last = end_of_search(trajectory, field, end);
        const Real bound = most_acceleration(trajectory, field, trajectory.time);
        const auto limits = tolerance(trajectory.position, reach, length(trajectory.velocity),
                                      bound, radius, field.pressing);
        found = first_time_of_impact<Real>(
            [&](const Real& time) -> Separation<Real> {
                const BallState<Real> state = state_at(trajectory, field, time);
                const Real up = dot(normal, state.position - edge.start);
                // A ball behind the side has no impact with it before it has come through: until
                // then its distance is the way to there.
                const Real side = up > zero ? Real(1.0) : Real(-1.0);
                Separation<Real> now{side * (up - reach), side * dot(normal, state.velocity), zero};
                if (trajectory.motion == Motion::turning) return now;
                const Real normal_acceleration =
                    side * dot(normal, acceleration_at(trajectory, field, state.velocity));
                now.acceleration_bound = normal_acceleration < zero ? -normal_acceleration : zero;
                return now;
            },
            trajectory.time, last, bound, weighed(limits, trajectory, field), search);
    }
    if (!found || !(*found <= end) || !is_beside(*found)) return std::nullopt;
    return found;
}

template <typename Real>
void take_earlier(std::optional<Real>& best, const std::optional<Real>& other) {
    if (other && (!best || *other < *best)) best = other;
}

// Whether the trajectory starts deeper in the edge than bodies that touch.
template <typename Real>
bool starts_inside(const Edge<Real>& edge, const Trajectory<Real>& trajectory, const Real& radius,
                   const Field<Real>& field) {
    const Real gap = contact_with(edge, trajectory.position, radius).gap;
    if (!(gap < Real{})) return false;
    const auto limits = tolerance(trajectory.position, radius + edge.radius,
                                  length(trajectory.velocity), Real{}, radius, field.pressing);
    return gap < -Real(4.0) * limits.slop;
}

// Time of impact with the nearest point of the whole edge, for a ball that starts inside of it or
// slides along it. Ends and sides one by one would not do: the ball enters the circle of an end
// while it is beside the edge, where there is no impact.
template <typename Real>
std::optional<Real> inside_time_of_impact(const Trajectory<Real>& trajectory,
                                          const Edge<Real>& edge, const Real& radius,
                                          const Field<Real>& field, const Real& end,
                                          ToiSearch<Real>& search) {
    const Real bound = most_acceleration(trajectory, field, trajectory.time);
    const auto limits = tolerance(trajectory.position, radius + edge.radius,
                                  length(trajectory.velocity), bound, radius, field.pressing);
    return first_time_of_impact<Real>(
        [&](const Real& time) -> Separation<Real> {
            const BallState<Real> state = state_at(trajectory, field, time);
            const auto contact = contact_with(edge, state.position, radius);
            Separation<Real> now{contact.gap, dot(contact.normal, state.velocity), Real{}};
            const Vector<Real> acceleration = acceleration_at(trajectory, field, state.velocity);
            now.normal_acceleration = dot(contact.normal, acceleration);
            now.relative_speed = length(state.velocity);
            now.center_distance = contact.gap + radius + edge.radius;
            return lasting_bound(now, acceleration, trajectory.motion == Motion::turning,
                                 field.has_drag);
        },
        trajectory.time, end_of_search(trajectory, field, end), bound,
        weighed(limits, trajectory, field), search);
}

// Whether the ball slides past at that time: beside the edge, without approaching its side.
template <typename Real>
bool slides_by(const Trajectory<Real>& trajectory, const Edge<Real>& edge, const Real& radius,
               const Field<Real>& field, const Real& time) {
    const BallState<Real> state = state_at(trajectory, field, time);
    const auto contact = contact_with(edge, state.position, radius);
    if (!(contact.place > Real{} && contact.place < Real(1.0))) return false;
    const auto limits =
        tolerance(state.position, radius, length(state.velocity), Real{}, radius, field.pressing);
    return !(dot(contact.normal, state.velocity) < -limits.rest_speed);
}

}  // namespace

template <typename Real>
std::optional<Real> edge_time_of_impact(const Trajectory<Real>& trajectory, const Edge<Real>& edge,
                                        const Real& radius, const Field<Real>& field,
                                        const Real& end, ToiSearch<Real>& search) {
    if (trajectory.motion == Motion::resting || trajectory.motion == Motion::still)
        return std::nullopt;
    if (!edge.is_point() && starts_inside(edge, trajectory, radius, field))
        return inside_time_of_impact(trajectory, edge, radius, field, end, search);
    const Real reach = radius + edge.radius;
    std::optional<Real> best =
        point_time_of_impact(trajectory, edge.start, reach, radius, field, end, search);
    if (edge.is_point()) return best;
    const Vector<Real> span = edge.end - edge.start;
    const Real whole = length(span);
    const Vector<Real> along = span / whole;
    const Vector<Real> left = perpendicular(along);
    take_earlier(best, point_time_of_impact(trajectory, edge.end, reach, radius, field,
                                            best ? *best : end, search));
    const std::optional<Real> at_end = best;
    for (const Vector<Real>& normal : {left, -left})
        take_earlier(best, side_time_of_impact(trajectory, edge, along, whole, normal, radius,
                                               field, best ? *best : end, search));
    if (best && best == at_end && slides_by(trajectory, edge, radius, field, *best))
        return inside_time_of_impact(trajectory, edge, radius, field, end, search);
    return best;
}

#define CAROM_FOR(Real)                                                                            \
    template EdgeContact<Real> contact_with(const Edge<Real>&, const Vector<Real>&, const Real&);  \
    template std::optional<Real> edge_time_of_impact(const Trajectory<Real>&, const Edge<Real>&,   \
                                                     const Real&, const Field<Real>&, const Real&, \
                                                     ToiSearch<Real>&);
CAROM_FOR(double)
CAROM_FOR(DoubleDouble)
#undef CAROM_FOR

}  // namespace carom
