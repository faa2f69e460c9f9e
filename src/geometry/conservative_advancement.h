#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "geometry/double_double.h"

/// The time of impact (TOI) of two bodies, as the first time at which their distance goes from
/// positive to negative: the root finders of the solver `event`.
///
/// A distance that grows, stays, or merely touches zero has no time of impact. An impact that has
/// been resolved is therefore never found again.
///
/// Units: any, as long as lengths and times agree. Real: double or DoubleDouble.
namespace carom {

/// The separation of two bodies at one time, with its derivatives.
template <typename Real>
struct Separation {
    Real distance;      ///< length; negative: depth of overlap
    Real velocity;      ///< its derivative, length/s; negative: approach
    Real acceleration;  ///< its second derivative, length/s^2
    /// What turns the normal, where it is known: the relative acceleration along the normal,
    /// length/s^2; the relative speed, length/s; the distance of the centres, length. All 0: not
    /// known.
    Real normal_acceleration{};
    Real relative_speed{};
    Real center_distance{};
    /// From now on the second derivative is nowhere below -acceleration_bound, length/s^2.
    /// Negative: not known.
    Real acceleration_bound{-1.0};
};

/// What counts as touching and what as an approach.
template <typename Real>
struct ToiTolerance {
    Real slop;        ///< length: bodies no further apart touch
    Real rest_speed;  ///< length/s: bodies that touch and approach more slowly have no impact
    /// Raises the rest speed of bodies that are pressed together: an approach more slowly than in a
    /// fall through half of this height, with the acceleration that presses them, is no impact.
    /// Length; 0: no such rule.
    Real rest_height{};

    Real rest_speed_at(const Separation<Real>& now) const {
        const bool is_pressed = rest_height > Real{} && now.normal_acceleration < Real{};
        if (!is_pressed) return rest_speed;
        const Real pressed = square_root(rest_height * -now.normal_acceleration);
        return rest_speed < pressed ? pressed : rest_speed;
    }
};

/// Advancement of bodies that touch without a noticeable approach: a time, s, in which they do not
/// begin one.
///
/// The acceleration bound alone allows steps of rest_speed / bound. They are far longer where the
/// normal hardly turns: it turns by less than m in a time of m d / 2 v, and in sqrt(m d / bound),
/// with d the distance of the centres and v the relative speed. For that long the separation's
/// acceleration is at least normal_acceleration - m bound. The function takes the best of a few m.
template <typename Real>
Real touching_step(const Separation<Real>& now, const Real& acceleration_bound,
                   const Real& rest_speed) {
    const auto until_approach = [&](const Real& against) {
        return (now.velocity > rest_speed ? now.velocity + now.velocity
                                          : now.velocity + rest_speed) /
               against;
    };
    Real best = until_approach(acceleration_bound);
    if (!(now.center_distance > Real{})) return best;
    for (const double turn : {0.125, 0.01, 0.001}) {
        const Real m(turn);
        Real limit = square_root(m * now.center_distance / acceleration_bound);
        if (now.relative_speed * limit > m * now.center_distance * Real(0.5))
            limit = m * now.center_distance * Real(0.5) / now.relative_speed;
        const Real against = m * acceleration_bound - now.normal_acceleration;
        Real step = limit;
        if (against > Real{}) {
            const Real reach = until_approach(against);
            if (reach < step) step = reach;
        }
        if (best < step) best = step;
    }
    return best;
}

/// Time of impact, >= 0, of bodies whose distance is exactly
/// distance + velocity t + acceleration t^2 / 2, in closed form: no term cancels.
///
/// Touching and approaching faster than `rest_speed`: 0. Touching, leaving or at rest, and
/// accelerated together: when they approach again noticeably.
template <typename Real>
std::optional<Real> quadratic_time_of_impact(const Separation<Real>& now,
                                             const ToiTolerance<Real>& tolerance) {
    const Real zero{};
    if (now.distance <= tolerance.slop) {
        const Real& rest_speed = tolerance.rest_speed;
        if (now.velocity < -rest_speed) return zero;
        if (!(now.acceleration < zero)) return std::nullopt;
        if (now.velocity > rest_speed) return (now.velocity + now.velocity) / -now.acceleration;
        return (now.velocity + rest_speed) / -now.acceleration;
    }
    const Real discriminant =
        now.velocity * now.velocity - Real(2.0) * now.acceleration * now.distance;
    if (now.velocity < zero) {
        if (!(discriminant > zero)) return std::nullopt;
        return Real(2.0) * now.distance / (square_root(discriminant) - now.velocity);
    }
    if (!(now.acceleration < zero)) return std::nullopt;
    return (now.velocity + square_root(discriminant)) / -now.acceleration;
}

/// What many searches share: the iterations they took, and until when the suspended ones found
/// nothing.
///
/// A search that takes too many iterations is suspended: it finds nothing, and notes how far it
/// came. The caller repeats the search at that time, from the same beginning. Nothing is passed
/// over then, and what is found does not depend on how often a search was suspended.
template <typename Real>
struct ToiSearch {
    /// Iterations of one search after `now`, until it is suspended. A search that is repeated gets
    /// as many as it takes to come to `now`, so that all repetitions together cost no more than a
    /// few times one search.
    static constexpr std::uint32_t most_iterations = 65536;

    Real now{};                       ///< searches go on until later than this, s
    std::optional<Real> resume_time;  ///< of the suspended search that came least far, s
    std::uint64_t iterations = 0;     ///< of all searches

    /// The searches that follow start anew at `time`.
    void begin_at(const Real& time) {
        now = time;
        resume_time.reset();
    }
    void suspend(const Real& time) {
        if (!resume_time || time < *resume_time) resume_time = time;
    }
};

/// Time of impact in begin..end of bodies on any trajectories, by conservative advancement.
///
/// `separation_at(t)`: the separation at time t. `acceleration_bound`, length/s^2, >= 0: as long as
/// the bodies are apart, the second derivative of their distance is nowhere below its negative.
/// Where Separation::acceleration_bound is far sharper, as for bodies that move side by side, the
/// search uses that.
///
/// Method: after s seconds the distance is at least
///
///     distance + velocity s - bound s^2 / 2
///
/// so its first root is a step that cannot pass over an impact; near the impact the steps shrink
/// quadratically. The result is the first time at which the distance is at most `slop` and shrinks
/// faster than the rest speed. It is late by no more than rounding, and no impact is passed over
/// whose depth would reach `slop`. A separation that turns back before its overlap would reach
/// 4 slop only grazes. Nothing found: none until `end`, or `search` has been told of a suspension.
///
/// Cost: one call of `separation_at` an iteration; usually under ten.
template <typename Real, typename SeparationAt>
std::optional<Real> first_time_of_impact(SeparationAt&& separation_at, Real begin, Real end,
                                         Real acceleration_bound,
                                         const ToiTolerance<Real>& tolerance,
                                         ToiSearch<Real>& search) {
    const Real zero{};
    Real time = begin;
    std::uint32_t repeated = 0;
    std::uint32_t iterations = 0;
    while (iterations < std::max(repeated, ToiSearch<Real>::most_iterations)) {
        const Separation<Real> now = separation_at(time);
        ++search.iterations;
        const bool is_sharper = !(now.acceleration_bound < zero) &&
                                Real(64.0) * now.acceleration_bound < acceleration_bound;
        const Real& bound = is_sharper ? now.acceleration_bound : acceleration_bound;
        Real step{};
        if (now.distance <= tolerance.slop) {
            const bool grazes =
                now.acceleration > zero &&
                now.velocity * now.velocity < Real(8.0) * now.acceleration * tolerance.slop;
            const Real rest_speed = tolerance.rest_speed_at(now);
            if (now.velocity < -rest_speed && !grazes) return time;
            if (!(bound > zero)) return std::nullopt;
            if (grazes && now.velocity < zero)
                step = Real(-2.0) * now.velocity / now.acceleration;
            else
                step = touching_step(now, bound, rest_speed);
        } else if (now.velocity < zero) {
            step = Real(2.0) * now.distance /
                   (square_root(now.velocity * now.velocity + Real(2.0) * bound * now.distance) -
                    now.velocity);
        } else {
            if (!(bound > zero)) return std::nullopt;
            step = (now.velocity +
                    square_root(now.velocity * now.velocity + Real(2.0) * bound * now.distance)) /
                   bound;
        }
        const Real least = Real(precision<Real>) * absolute(time);
        time += step > least ? step : least;
        if (!(time <= end)) return std::nullopt;
        ++(search.now < time ? iterations : repeated);
    }
    search.suspend(time);
    return std::nullopt;
}

}  // namespace carom
