#pragma once

#include <optional>

#include "geometry/conservative_advancement.h"
#include "geometry/shapes.h"
#include "physics/event/motion/tolerances.h"
#include "physics/event/motion/trajectory.h"

/// The time of impact of two trajectories, or of a trajectory and an edge: when they first touch
/// and approach. geometry/conservative_advancement.h says what counts as an impact, and README.md
/// why none is missed.
///
/// All times are absolute, s; `end` is the horizon of the search. Each function gives the same bits
/// whenever it is asked, since it starts from the trajectories alone. Straight lines and parabolas
/// are solved in closed form; other motion takes a search of a few iterations.
namespace carom {

/// A capsule over any number type.
template <typename Real>
struct Edge {
    Vector<Real> start;
    Vector<Real> end;
    Real radius{};

    Edge() = default;
    Edge(const Capsule& shape, Vec2 shift)
        : start(Vector<Real>(shape.start) + Vector<Real>(shift)),
          end(Vector<Real>(shape.end) + Vector<Real>(shift)),
          radius(shape.radius) {}
    bool is_point() const { return start == end; }
};

/// A kinematic edge: each of its ends moves uniformly from `time` until `stop`.
template <typename Real>
struct MovingEdge {
    Edge<Real> edge;  ///< at `time`
    Vector<Real> start_velocity;
    Vector<Real> end_velocity;
    Real time{};
    Real stop{};

    Edge<Real> at(const Real& when) const;
};

/// How a ball lies to an edge.
template <typename Real>
struct EdgeContact {
    Real gap{};           ///< length; negative: depth of overlap
    Vector<Real> normal;  ///< from the edge to the ball, unit
    Real place{};         ///< nearest point of the spine: 0 at its start, 1 at its end
};

/// Beside the edge the normal is that of the spine, and does not depend on where the ball is. With
/// its centre on the spine's end, the ball has the normal (0, 1).
template <typename Real>
EdgeContact<Real> contact_with(const Edge<Real>& edge, const Vector<Real>& position,
                               const Real& radius);

/// The rounding of a gap measured at this position, length: gaps up to this are contacts.
template <typename Real>
inline Real rounding_at(const Vector<Real>& position, const Real& reach) {
    return Real(4.0 * precision<Real>) * (absolute(position.x) + absolute(position.y) + reach);
}

/// Ball a as seen from ball b when the later of their trajectories begins. Both must have the same
/// `acceleration`, so that each sees the other move uniformly. `shift` is added to b's position.
template <typename Real>
struct StraightPair {
    Real begin;
    Vector<Real> velocity;
    Vector<Real> offset;

    StraightPair(const LinearPart<Real>& a, const LinearPart<Real>& b,
                 const Vector<Real>& acceleration, const Vector<Real>& shift)
        : begin(a.time < b.time ? b.time : a.time) {
        const Real half(0.5);
        const Real since_a = begin - a.time;
        const Real since_b = begin - b.time;
        velocity = a.velocity - b.velocity + acceleration * (since_a - since_b);
        offset = (a.position + (a.velocity + acceleration * (half * since_a)) * since_a) -
                 (b.position + (b.velocity + acceleration * (half * since_b)) * since_b) - shift;
    }
};

/// Whether a body that moves uniformly, at `offset` from another and with the relative `velocity`,
/// will come within `reach` of it. The bits are the same seen from either body.
template <typename Real>
struct StraightApproach {
    Real approach{};  ///< speed of approach times distance; positive: approach
    Real discriminant{};

    StraightApproach() = default;
    StraightApproach(const Vector<Real>& offset, const Vector<Real>& velocity, const Real& reach)
        : approach(-dot(offset, velocity)) {
        const Real miss = cross(offset, velocity);
        discriminant = length_squared(velocity) * reach * reach - miss * miss;
    }
    /// Computes both conditions before it asks either: no processor can predict the first.
    bool is_impact() const {
        return static_cast<int>(approach > Real{}) & static_cast<int>(discriminant > Real{});
    }
};

/// When the two come within `reach`. `a` and `b` are the trajectories; `offset` is that of a as
/// seen from b at `begin`; `small` is the smaller radius. None where they touch and approach no
/// faster than rounding.
/// Pre: approach.is_impact().
template <typename Real>
inline std::optional<Real> straight_time_of_impact(
    const StraightApproach<Real>& approach, const LinearPart<Real>& a, const LinearPart<Real>& b,
    const Real& begin, const Vector<Real>& offset, const Vector<Real>& acceleration,
    const Real& reach, const Real& small, const Field<Real>& field) {
    const Real distance = length(offset);
    const Real gap = distance - reach;
    if (gap <= rounding_at(a.position, reach)) {
        const Real speed = approach.approach / distance;
        const Real rounding = Real(approach_rounding<Real>) *
                                  (length(a.velocity) + length(b.velocity) +
                                   length(acceleration) * ((begin - a.time) + (begin - b.time))) +
                              Real(pressed_rounding) * square_root(field.pressing * small) +
                              Real(least_approach);
        if (!(speed > rounding)) return std::nullopt;
        // Slow pairs in a heap may sink in by a rest height before they meet again.
        const Real height = Real(moving_rest_height) * small;
        const Real rest_speed = square_root(Real(2.0) * field.pressing * height);
        if (!(speed < rest_speed) || !(-height < gap)) return begin;
        return begin + (gap + height) / speed;
    }
    // Both terms of the denominator are positive, so nothing cancels.
    return begin +
           gap * (distance + reach) / (approach.approach + square_root(approach.discriminant));
}

/// Time of impact of two balls in uniform motion as seen from one another: both have the
/// `acceleration`. Defined here, since a gas spends nearly all its time in it.
template <typename Real>
inline std::optional<Real> straight_time_of_impact(const Trajectory<Real>& a,
                                                   const Trajectory<Real>& b,
                                                   const Vector<Real>& acceleration,
                                                   const Vector<Real>& shift, const Real& reach,
                                                   const Real& small, const Field<Real>& field) {
    const StraightPair<Real> pair(a, b, acceleration, shift);
    const StraightApproach<Real> approach(pair.offset, pair.velocity, reach);
    if (!approach.is_impact()) return std::nullopt;
    return straight_time_of_impact(approach, a, b, pair.begin, pair.offset, acceleration, reach,
                                   small, field);
}

/// Time of impact of two balls, no earlier than both trajectories begin and no later than `end`.
/// `shift` is added to b's position (a periodic image); `reach` is the sum of the radii, `small`
/// the smaller.
template <typename Real>
std::optional<Real> ball_time_of_impact(const Trajectory<Real>& a, const Trajectory<Real>& b,
                                        const Vector<Real>& shift, const Real& reach,
                                        const Real& small, const Field<Real>& field,
                                        const Real& end, ToiSearch<Real>& search);

/// Time of impact of a ball and an edge that does not move.
///
/// A ball that starts deeper in the edge than bodies that touch, as dense clusters leave some, is
/// searched with the nearest point of the whole edge. So is a ball that slides along the edge.
/// Otherwise the two ends and the two sides are solved one by one.
template <typename Real>
std::optional<Real> edge_time_of_impact(const Trajectory<Real>& trajectory, const Edge<Real>& edge,
                                        const Real& radius, const Field<Real>& field,
                                        const Real& end, ToiSearch<Real>& search);

/// Time of impact of a ball and a kinematic edge, in begin..end. The bound on the edge's motion
/// assumes that it turns no faster than twice the difference of its ends' speeds over its length.
/// A suspended search resumes from a later `begin`: ticks with kinematic edges are never continued,
/// so nobody could start it from the trajectory alone.
template <typename Real>
std::optional<Real> moving_edge_time_of_impact(const Trajectory<Real>& trajectory,
                                               const MovingEdge<Real>& edge, const Real& radius,
                                               const Field<Real>& field, const Real& begin,
                                               const Real& end, ToiSearch<Real>& search);

}  // namespace carom
