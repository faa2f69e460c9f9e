#pragma once

#include <optional>

#include "geometry/closing.h"
#include "geometry/shapes.h"
#include "physics/event/trajectory.h"

/// When two paths, or a path and an edge, first meet: see geometry/closing.h for what counts.
namespace carom {

/// Bodies that gravity presses together and that touch have an impact only once they approach at
/// the speed of a fall through this share of the smaller radius. What rises less after a bounce,
/// rests.
inline constexpr double resting_rise = 1e-9;
/// The same of two balls that both move: what they are pressed together then, and what they lose no
/// more of once they rise less. So their impacts stay finite in number.
inline constexpr double lively_rise = 1e-5;

/// The same of two balls of which cloth pushes at least one towards the other. Their impacts lose
/// nothing once they rise less.
inline constexpr double pushing_rise = 1e-7;
/// The same, with all of the acceleration, of balls on cloth that touch and that nothing presses
/// together.
inline constexpr double unpressed_rise = 1e-11;

/// Approaches below this share of the speeds are rounding, and no impacts. What is left of an
/// approach after an impact is less (event_impact.cpp), so that no impact is found twice.
template <typename Real>
inline constexpr double impact_noise = 1024.0 * precision<Real>;

/// Length/s: slower ones are none, since shares of them are lost where numbers end.
inline constexpr double least_approach = 1e-280;

/// What of an approach is left to be rounding, at an impact: a share of the speeds.
template <typename Real>
inline constexpr double approach_noise = 0.125 * impact_noise<Real>;

/// The same where balls come to be pressed together: a share of the speed that gravity gives in a
/// fall through a radius.
inline constexpr double pressing_noise = 8e-10;

/// A capsule in another number type.
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

/// An edge in a hand: its ends move from `time` on, until `stop`.
template <typename Real>
struct MovingEdge {
    Edge<Real> edge;  ///< at `time`
    Vector<Real> start_velocity;
    Vector<Real> end_velocity;
    Real time{};
    Real stop{};

    Edge<Real> at(const Real& when) const;
};

/// Where a ball touches an edge, or would.
template <typename Real>
struct EdgeContact {
    Real gap{};           ///< length
    Vector<Real> normal;  ///< from the edge to the ball, unit
    Real place{};         ///< of the nearest point of the spine, 0 at the start, 1 at the end
};
template <typename Real>
EdgeContact<Real> contact_with(const Edge<Real>& edge, const Vector<Real>& position,
                               const Real& radius);

/// What is rounding at this place: gaps up to this are touches. Length.
template <typename Real>
inline Real rounding_at(const Vector<Real>& position, const Real& reach) {
    return Real(4.0 * precision<Real>) * (absolute(position.x) + absolute(position.y) + reach);
}

/// Two paths with the same `acceleration` where the later of them begins: the first as seen from
/// the second, whose place `shift` is added to.
template <typename Real>
struct StraightPair {
    Real begin;
    Vector<Real> velocity;
    Vector<Real> offset;

    StraightPair(const EventLine<Real>& a, const EventLine<Real>& b,
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

/// Two balls that move in straight lines as seen from one another, `offset` apart (of the centres,
/// from one to the other's) with the relative `velocity`: whether they are going to meet within
/// `reach`. Seen from either, the bits are the same.
template <typename Real>
struct LineMeeting {
    Real closing{};
    Real discriminant{};

    LineMeeting() = default;
    LineMeeting(const Vector<Real>& offset, const Vector<Real>& velocity, const Real& reach)
        : closing(-dot(offset, velocity)) {
        const Real miss = cross(offset, velocity);
        discriminant = length_squared(velocity) * reach * reach - miss * miss;
    }
    /// Both are worked out before either is asked, since nobody can foretell the first.
    bool is_one() const {
        return static_cast<int>(closing > Real{}) & static_cast<int>(discriminant > Real{});
    }
};

/// When they do, the paths being `a` and `b`, `offset` and `velocity` those of a seen from b at
/// `begin`. Nothing where they touch already and part, or close no faster than rounding.
template <typename Real>
inline std::optional<Real> meeting_time(const LineMeeting<Real>& meeting, const EventLine<Real>& a,
                                        const EventLine<Real>& b, const Real& begin,
                                        const Vector<Real>& offset,
                                        const Vector<Real>& acceleration, const Real& reach,
                                        const Real& small, const Field<Real>& field) {
    const Real away = length(offset);
    const Real gap = away - reach;
    if (gap <= rounding_at(a.position, reach)) {
        const Real rate = meeting.closing / away;
        const Real noise = Real(impact_noise<Real>) *
                               (length(a.velocity) + length(b.velocity) +
                                length(acceleration) * ((begin - a.time) + (begin - b.time))) +
                           Real(pressing_noise) * square_root(field.pressing * small) +
                           Real(least_approach);
        if (!(rate > noise)) return std::nullopt;
        // In a heap what closes slowly may sink in by a hair before it counts.
        const Real hair = Real(lively_rise) * small;
        const Real slow = square_root(Real(2.0) * field.pressing * hair);
        if (!(rate < slow) || !(-hair < gap)) return begin;
        return begin + (gap + hair) / rate;
    }
    // Both terms of the denominator are positive, so nothing cancels.
    return begin + gap * (away + reach) / (meeting.closing + square_root(meeting.discriminant));
}

/// First impact of two balls on parabolas of the same `acceleration`, which are straight lines as
/// seen from one another, no earlier than both paths begin. `shift`, `reach` and `small`: as below.
template <typename Real>
inline std::optional<Real> straight_closing(const EventPath<Real>& a, const EventPath<Real>& b,
                                            const Vector<Real>& acceleration,
                                            const Vector<Real>& shift, const Real& reach,
                                            const Real& small, const Field<Real>& field);

/// First impact of two balls, no earlier than both paths begin and no later than `end`. `shift` is
/// added to the second path's place (an image on a torus); `reach` is the sum of the radii, `small`
/// the smaller.
template <typename Real>
std::optional<Real> ball_closing(const EventPath<Real>& a, const EventPath<Real>& b,
                                 const Vector<Real>& shift, const Real& reach, const Real& small,
                                 const Field<Real>& field, const Real& end,
                                 ClosingSearch<Real>& search);

/// The same of a ball and an edge that stands still.
template <typename Real>
std::optional<Real> edge_closing(const EventPath<Real>& path, const Edge<Real>& edge,
                                 const Real& radius, const Field<Real>& field, const Real& end,
                                 ClosingSearch<Real>& search);

/// The same of a ball and an edge in a hand, between `begin` and `end`. The bound on its motion
/// takes the edge to turn no faster than twice the difference of its ends' speeds over its length.
/// A search that was left off goes on from `begin`, which is later then: a tick with hands is never
/// gone on with, so nobody could begin it otherwise.
template <typename Real>
std::optional<Real> hand_closing(const EventPath<Real>& path, const MovingEdge<Real>& edge,
                                 const Real& radius, const Field<Real>& field, const Real& begin,
                                 const Real& end, ClosingSearch<Real>& search);

// Here, since nearly all the time of a gas goes into it.
template <typename Real>
inline std::optional<Real> straight_closing(const EventPath<Real>& a, const EventPath<Real>& b,
                                            const Vector<Real>& acceleration,
                                            const Vector<Real>& shift, const Real& reach,
                                            const Real& small, const Field<Real>& field) {
    const StraightPair<Real> pair(a, b, acceleration, shift);
    const LineMeeting<Real> meeting(pair.offset, pair.velocity, reach);
    if (!meeting.is_one()) return std::nullopt;
    return meeting_time(meeting, a, b, pair.begin, pair.offset, acceleration, reach, small, field);
}

}  // namespace carom
