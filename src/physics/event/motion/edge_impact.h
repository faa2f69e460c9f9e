#pragma once

#include <optional>

#include "geometry/shapes.h"
#include "physics/event/motion/time_of_impact.h"

/// When a ball hits an edge, fixed or kinematic, and where it is relative to one. See
/// time_of_impact.h for what all searches have in common.
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

/// A kinematic edge: each of its ends moves uniformly from `time` until `stop`. The edge of a
/// seesaw turns about its hinge at a constant rate instead.
template <typename Real>
struct MovingEdge {
    Edge<Real> edge;  ///< at `time`
    Vector<Real> start_velocity;
    Vector<Real> end_velocity;
    Real time{};
    Real stop{};
    bool is_hinged = false;  ///< then no velocities
    Vector<Real> pivot;
    Real rate{};  ///< rad/s

    Edge<Real> at(const Real& when) const;
};

/// Where a ball is relative to an edge.
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

/// Time of impact of a ball and an edge that does not move.
///
/// Usually the two ends and the two sides are solved one by one. There are two exceptions, in which
/// the search is for the nearest point of the whole edge: a ball that slides along the edge, and a
/// ball that starts deeper in the edge than bodies that touch, as dense clusters leave some.
template <typename Real>
std::optional<Real> edge_time_of_impact(const Trajectory<Real>& trajectory, const Edge<Real>& edge,
                                        const Real& radius, const Field<Real>& field,
                                        const Real& end, ToiSearch<Real>& search);

/// Time of impact of a ball and a kinematic edge, in begin..end.
///
/// The bound of the search is, for ends with velocities u and v,
///
///     A = B + w (2 S + w (D + S T))    with w = 2 |v - u| / L and S = s + B T
///
/// B is the ball's most_acceleration, L the edge's length, D the distance of the ball's centre from
/// the edge's spine, and s the ball's speed plus that of the faster end, all at `begin`; T = end -
/// begin. It holds while the edge is at least L / 2 long, so that it turns no faster than w. An
/// edge that shrinks further in a tick may miss an impact. README.md derives the bound.
///
/// For the edge of a seesaw that turns at the rate w, exactly on its arc, it is
///
///     A = B + w (2 S + w (P + S T))
///
/// with P the distance of the ball's centre from the hinge at `begin`, and s the ball's speed
/// alone.
///
/// The result depends on `begin` and `end`, and a suspended search resumes from a later `begin`: no
/// tick with kinematic edges is continued, so the search need not be repeatable from the trajectory
/// alone.
template <typename Real>
std::optional<Real> moving_edge_time_of_impact(const Trajectory<Real>& trajectory,
                                               const MovingEdge<Real>& edge, const Real& radius,
                                               const Field<Real>& field, const Real& begin,
                                               const Real& end, ToiSearch<Real>& search);

}  // namespace carom
