#include "physics/event/toi_search.h"

namespace carom {
namespace {

template <typename Real>
const Real& lesser(const Real& a, const Real& b) {
    return b < a ? b : a;
}
template <typename Real>
const Real& greater(const Real& a, const Real& b) {
    return a < b ? b : a;
}

template <typename Real>
ClosingTolerance<Real> tolerance(const Vector<Real>& position, const Real& reach,
                                 const Real& speeds, const Real& pull, const Real& small,
                                 const Real& pressing, double rise = resting_rise) {
    const Real noise = Real(impact_noise<Real>) * speeds +
                       Real(pressing_noise) * square_root(pressing * small) + Real(least_approach);
    const Real slow = pull > Real{} ? square_root(Real(2.0 * rise) * pull * small) : Real{};
    return {rounding_at(position, reach), greater(noise, slow)};
}

// Of a point at `offset` from another, both carried by paths.
template <typename Real>
Gap<Real> gap_of(const Vector<Real>& offset, const Vector<Real>& velocity,
                 const Vector<Real>& acceleration, const Real& reach) {
    const Real away = length(offset);
    if (!(away > Real{})) return {-reach, Real{}, Real{}, Real{}, Real{}, Real{}};
    const Vector<Real> normal = offset / away;
    const Real rate = dot(normal, velocity);
    const Real across = cross(normal, velocity);
    const Real lean = dot(normal, acceleration);
    return {away - reach, rate, across * across / away + lean, lean, length(velocity), away};
}

// Drag makes all accelerations die away at the same rate: what presses now will press no more
// strongly, and what does not press never will. Of what turns the acceleration now says nothing.
template <typename Real>
Gap<Real> lasting(Gap<Real> gap, const Vector<Real>& acceleration, bool turns, bool has_drag) {
    if (turns) {
        gap.distance = Real{};
    } else if (has_drag) {
        gap.pull = length(acceleration);
        if (Real{} < gap.lean) gap.lean = Real{};
    }
    return gap;
}

template <typename Real>
Vector<Real> acceleration_at(const EventPath<Real>& path, const Field<Real>& field,
                             const Vector<Real>& velocity) {
    if (path.motion == Motion::turning) return {};
    if (!field.has_drag || path.motion == Motion::held) return path.acceleration;
    return path.acceleration - velocity * field.drag;
}

template <typename Real>
Real last_moment(const EventPath<Real>& path, const Field<Real>& field, const Real& end) {
    return path.motion == Motion::turning ? lesser(end, piece_end(path, field)) : end;
}

// With a point that stands still, on paths that are no straight lines.
template <typename Real>
std::optional<Real> point_closing(const EventPath<Real>& path, const Vector<Real>& point,
                                  const Real& reach, const Real& small, const Field<Real>& field,
                                  const Real& end, ClosingSearch<Real>& search) {
    // Round the very point, as from one edge to the next: it comes no nearer.
    if (path.motion == Motion::turning && path.center == point) return std::nullopt;
    const Real last = last_moment(path, field, end);
    const Real pull = most_acceleration(path, field, path.time);
    const auto limits =
        tolerance(path.position, reach, length(path.velocity), pull, small, field.pressing);
    if (!(pull > Real{}) && is_parabola(path, field)) {
        const Vector<Real> offset = path.position - point;
        const Real closing = -dot(offset, path.velocity);
        if (!(closing > Real{})) return std::nullopt;
        const Gap<Real> now = gap_of(offset, path.velocity, Vector<Real>{}, reach);
        if (now.gap <= limits.touch)
            return now.rate < -limits.slow ? std::optional<Real>(path.time) : std::nullopt;
        const Real speed_squared = length_squared(path.velocity);
        const Real miss = cross(offset, path.velocity);
        const Real discriminant = speed_squared * reach * reach - miss * miss;
        if (!(discriminant > Real{})) return std::nullopt;
        // Both terms of the denominator are positive, so nothing cancels.
        const Real time =
            path.time + now.gap * (length(offset) + reach) / (closing + square_root(discriminant));
        return time <= end ? std::optional<Real>(time) : std::nullopt;
    }
    return first_closing<Real>(
        [&](const Real& time) {
            const BallState<Real> state = state_at(path, field, time);
            const Vector<Real> acceleration = acceleration_at(path, field, state.velocity);
            return lasting(gap_of(state.position - point, state.velocity, acceleration, reach),
                           acceleration, path.motion == Motion::turning, field.has_drag);
        },
        path.time, last, pull, limits, search);
}

// With the side of an edge on which `normal` stands: where the ball's foot is within the edge.
template <typename Real>
std::optional<Real> side_closing(const EventPath<Real>& path, const Edge<Real>& edge,
                                 const Vector<Real>& along, const Real& whole,
                                 const Vector<Real>& normal, const Real& radius,
                                 const Field<Real>& field, const Real& end,
                                 ClosingSearch<Real>& search) {
    const Real reach = radius + edge.radius;
    const Vector<Real> offset = path.position - edge.start;
    const Real height = dot(normal, offset);
    const Real rate = dot(normal, path.velocity);
    const Real bend = dot(normal, path.acceleration);
    const Real zero{};
    const auto is_beside = [&](const Real& time) {
        const Real place = dot(along, state_at(path, field, time).position - edge.start);
        return place >= zero && place <= whole;
    };
    std::optional<Real> found;
    if (is_parabola(path, field)) {
        auto limits = tolerance(path.position, reach, length(path.velocity),
                                bend < zero ? -bend : zero, radius, field.pressing);
        limits.touch += rounding_at(offset, reach);
        const Real gap = height - reach;
        if (!(gap < -limits.touch)) {
            const auto since = quadratic_closing<Real>({gap, rate, bend}, limits);
            if (since) found = path.time + *since;
        } else {
            const bool overlaps = height > zero && is_beside(path.time);
            if (overlaps && rate < -limits.slow) return path.time;
            if (!(bend < zero)) return std::nullopt;
            // Below the height of a touch: it must rise over it first, and fall again.
            const Real discriminant = rate * rate - Real(2.0) * bend * gap;
            if (rate > zero && discriminant > zero)
                found = path.time + (rate + square_root(discriminant)) / -bend;
            else if (overlaps)
                found = path.time + (rate + limits.slow) / -bend;
        }
    } else {
        const Real last = last_moment(path, field, end);
        const Real pull = most_acceleration(path, field, path.time);
        const auto limits =
            tolerance(path.position, reach, length(path.velocity), pull, radius, field.pressing);
        found = first_closing<Real>(
            [&](const Real& time) -> Gap<Real> {
                const BallState<Real> state = state_at(path, field, time);
                const Real up = dot(normal, state.position - edge.start);
                // What is under the line has no gap on this side.
                Gap<Real> now{up > zero ? up - reach : reach - up, dot(normal, state.velocity),
                              zero};
                if (path.motion == Motion::turning) return now;
                const Real lean = dot(normal, acceleration_at(path, field, state.velocity));
                now.pull = lean < zero ? -lean : zero;
                return now;
            },
            path.time, last, pull, limits, search);
    }
    if (!found || !(*found <= end) || !is_beside(*found)) return std::nullopt;
    return found;
}

template <typename Real>
void take_earlier(std::optional<Real>& best, const std::optional<Real>& other) {
    if (other && (!best || *other < *best)) best = other;
}

}  // namespace

template <typename Real>
Edge<Real> MovingEdge<Real>::at(const Real& when) const {
    const Real since = lesser(when, stop) - time;
    Edge<Real> moved = edge;
    moved.start += start_velocity * since;
    moved.end += end_velocity * since;
    return moved;
}

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
        // Beside: the normal of the edge, which does not depend on where the ball is.
        const Vector<Real> left = perpendicular(span) / square_root(square);
        normal = dot(left, offset) < zero ? -left : left;
    } else if (away > zero) {
        normal = offset / away;
    }
    return {away - radius - edge.radius, normal, place};
}

template <typename Real>
std::optional<Real> ball_closing(const EventPath<Real>& a, const EventPath<Real>& b,
                                 const Vector<Real>& shift, const Real& reach, const Real& small,
                                 const Field<Real>& field, const Real& end,
                                 ClosingSearch<Real>& search) {
    if (is_parabola(a, field) && is_parabola(b, field) && a.acceleration == b.acceleration) {
        const auto time = straight_closing(a, b, a.acceleration, shift, reach, small, field);
        return time && *time <= end ? time : std::nullopt;
    }
    const Real begin = greater(a.time, b.time);
    const Real last = lesser(last_moment(a, field, end), last_moment(b, field, end));
    if (last < begin) return std::nullopt;
    Real pull = most_acceleration(a, field, begin) + most_acceleration(b, field, begin);
    if (is_parabola(a, field) && is_parabola(b, field))
        pull = length(a.acceleration - b.acceleration);
    const auto look = [&](const Real& time) {
        const BallState<Real> at_a = state_at(a, field, time);
        const BallState<Real> at_b = state_at(b, field, time);
        const Vector<Real> acceleration =
            acceleration_at(a, field, at_a.velocity) - acceleration_at(b, field, at_b.velocity);
        return lasting(gap_of(at_a.position - at_b.position - shift, at_a.velocity - at_b.velocity,
                              acceleration, reach),
                       acceleration, a.motion == Motion::turning || b.motion == Motion::turning,
                       field.has_drag);
    };
    const bool one_rests = a.motion == Motion::resting || b.motion == Motion::resting;
    const bool on_cloth = is_on_cloth(a) || is_on_cloth(b);
    const double rise = on_cloth ? unpressed_rise : (one_rests ? resting_rise : lively_rise);
    auto limits = tolerance(a.position, reach, length(a.velocity) + length(b.velocity), pull, small,
                            field.pressing, rise);
    const bool is_held = a.motion == Motion::held || b.motion == Motion::held;
    if (on_cloth) limits.rise = Real(2.0 * (is_held ? lively_rise : pushing_rise)) * small;
    return first_closing<Real>(look, begin, last, pull, limits, search);
}

namespace {

// Whether the path begins deeper in the edge than bodies that touch are, as heaps leave balls.
template <typename Real>
bool is_in(const Edge<Real>& edge, const EventPath<Real>& path, const Real& radius,
           const Field<Real>& field) {
    const Real gap = contact_with(edge, path.position, radius).gap;
    if (!(gap < Real{})) return false;
    const auto limits = tolerance(path.position, radius + edge.radius, length(path.velocity),
                                  Real{}, radius, field.pressing);
    return gap < -Real(4.0) * limits.touch;
}

// Of such a path, with the nearest place of the edge, and of one that slides along the edge less
// deep. Its parts taken one by one would not do: the circle of an end is entered while the ball is
// beside the edge, where nothing is met.
template <typename Real>
std::optional<Real> closing_from_inside(const EventPath<Real>& path, const Edge<Real>& edge,
                                        const Real& radius, const Field<Real>& field,
                                        const Real& end, ClosingSearch<Real>& search) {
    const Real pull = most_acceleration(path, field, path.time);
    const auto limits = tolerance(path.position, radius + edge.radius, length(path.velocity), pull,
                                  radius, field.pressing);
    return first_closing<Real>(
        [&](const Real& time) -> Gap<Real> {
            const BallState<Real> state = state_at(path, field, time);
            const auto contact = contact_with(edge, state.position, radius);
            Gap<Real> now{contact.gap, dot(contact.normal, state.velocity), Real{}};
            const Vector<Real> acceleration = acceleration_at(path, field, state.velocity);
            now.lean = dot(contact.normal, acceleration);
            now.speed = length(state.velocity);
            now.distance = contact.gap + radius + edge.radius;
            return lasting(now, acceleration, path.motion == Motion::turning, field.has_drag);
        },
        path.time, last_moment(path, field, end), pull, limits, search);
}

// Whether the ball only slides by at that time: beside the edge, without approaching its side.
template <typename Real>
bool slides_by(const EventPath<Real>& path, const Edge<Real>& edge, const Real& radius,
               const Field<Real>& field, const Real& time) {
    const BallState<Real> state = state_at(path, field, time);
    const auto contact = contact_with(edge, state.position, radius);
    if (!(contact.place > Real{} && contact.place < Real(1.0))) return false;
    const auto limits =
        tolerance(state.position, radius, length(state.velocity), Real{}, radius, field.pressing);
    return !(dot(contact.normal, state.velocity) < -limits.slow);
}

}  // namespace

template <typename Real>
std::optional<Real> edge_closing(const EventPath<Real>& path, const Edge<Real>& edge,
                                 const Real& radius, const Field<Real>& field, const Real& end,
                                 ClosingSearch<Real>& search) {
    if (path.motion == Motion::resting || path.motion == Motion::still) return std::nullopt;
    if (!edge.is_point() && is_in(edge, path, radius, field))
        return closing_from_inside(path, edge, radius, field, end, search);
    const Real reach = radius + edge.radius;
    std::optional<Real> best = point_closing(path, edge.start, reach, radius, field, end, search);
    if (edge.is_point()) return best;
    const Vector<Real> span = edge.end - edge.start;
    const Real whole = length(span);
    const Vector<Real> along = span / whole;
    const Vector<Real> left = perpendicular(along);
    take_earlier(best,
                 point_closing(path, edge.end, reach, radius, field, best ? *best : end, search));
    const std::optional<Real> at_end = best;
    for (const Vector<Real>& normal : {left, -left})
        take_earlier(best, side_closing(path, edge, along, whole, normal, radius, field,
                                        best ? *best : end, search));
    if (best && best == at_end && slides_by(path, edge, radius, field, *best))
        return closing_from_inside(path, edge, radius, field, end, search);
    return best;
}

template <typename Real>
std::optional<Real> hand_closing(const EventPath<Real>& path, const MovingEdge<Real>& edge,
                                 const Real& radius, const Field<Real>& field, const Real& begin,
                                 const Real& end, ClosingSearch<Real>& search) {
    const Real last = last_moment(path, field, end);
    const bool moves = begin < edge.stop;
    const Vector<Real> from = moves ? edge.start_velocity : Vector<Real>{};
    const Vector<Real> to = moves ? edge.end_velocity : Vector<Real>{};
    const Edge<Real> shape = edge.at(begin);
    const Real whole = length(shape.end - shape.start);
    const BallState<Real> now = state_at(path, field, begin);
    const Real speed = length(now.velocity) + greater(length(from), length(to));
    Real pull = most_acceleration(path, field, begin);
    const Real zero{};
    if (whole > zero) {
        const Real turning = Real(2.0) * length(to - from) / whole;
        pull += turning * (Real(2.0) * (speed + pull * (last - begin)) + turning * whole);
    }
    const auto look = [&](const Real& time) -> Gap<Real> {
        const BallState<Real> state = state_at(path, field, time);
        const auto contact = contact_with(edge.at(time), state.position, radius);
        const Vector<Real> surface = from + (to - from) * contact.place;
        return {contact.gap, dot(contact.normal, state.velocity - surface), zero};
    };
    auto limits = tolerance(now.position, radius, speed, pull, radius, field.pressing,
                            is_on_cloth(path) ? lively_rise : resting_rise);
    return first_closing<Real>(look, begin, last, pull, limits, search);
}

#define CAROM_FOR(Real)                                                                           \
    template Edge<Real> MovingEdge<Real>::at(const Real&) const;                                  \
    template EdgeContact<Real> contact_with(const Edge<Real>&, const Vector<Real>&, const Real&); \
    template std::optional<Real> ball_closing(                                                    \
        const EventPath<Real>&, const EventPath<Real>&, const Vector<Real>&, const Real&,         \
        const Real&, const Field<Real>&, const Real&, ClosingSearch<Real>&);                      \
    template std::optional<Real> edge_closing(const EventPath<Real>&, const Edge<Real>&,          \
                                              const Real&, const Field<Real>&, const Real&,       \
                                              ClosingSearch<Real>&);                              \
    template std::optional<Real> hand_closing(const EventPath<Real>&, const MovingEdge<Real>&,    \
                                              const Real&, const Field<Real>&, const Real&,       \
                                              const Real&, ClosingSearch<Real>&);
CAROM_FOR(double)
CAROM_FOR(Wide)
#undef CAROM_FOR

}  // namespace carom
