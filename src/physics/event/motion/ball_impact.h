#pragma once

#include <optional>

#include "physics/event/motion/time_of_impact.h"

/// When two balls meet. See time_of_impact.h for what all searches have in common.
///
/// Two balls with the same acceleration see each other move uniformly, so their time of impact is
/// the root of a quadratic equation. These functions are defined here: a gas spends nearly all its
/// time in them. Other pairs are searched.
namespace carom {

/// Ball a as seen from ball b when the later of their trajectories begins. Both must have the same
/// `acceleration`, so that each sees the other move uniformly. `shift` is added to b's position.
template <typename Real>
struct StraightPair {
    Real begin;
    Vector<Real> velocity;
    Vector<Real> offset;

    /// Nothing accelerates the two, and no image is shifted.
    StraightPair(const LinearPart<Real>& a, const LinearPart<Real>& b)
        : begin(a.time < b.time ? b.time : a.time),
          velocity(a.velocity - b.velocity),
          offset((a.position + a.velocity * (begin - a.time)) -
                 (b.position + b.velocity * (begin - b.time))) {}
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

}  // namespace carom
