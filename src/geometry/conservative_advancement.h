#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "geometry/double_double.h"

/// Root finders of the solver `event`: the time of impact (TOI) of two bodies is the first time at
/// which their distance changes from positive to negative.
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
    /// The terms that turn the normal, where they are known: the relative acceleration along the
    /// normal, length/s^2; the relative speed, length/s; the distance of the centres, length. All
    /// 0: not known.
    Real normal_acceleration{};
    Real relative_speed{};
    Real center_distance{};
    /// From this time on the second derivative is nowhere below -acceleration_bound, length/s^2.
    /// Negative: not known.
    Real acceleration_bound{-1.0};
};

/// The thresholds that decide what counts as touching and what as an approach.
template <typename Real>
struct ToiTolerance {
    Real slop;        ///< length: bodies no further apart than this touch
    Real rest_speed;  ///< length/s: touching bodies that approach more slowly have no impact
    /// Raises the rest speed of bodies that are pressed together: an approach slower than a fall
    /// through half this height, at the acceleration that presses them, is no impact. Length; 0
    /// switches the rule off.
    Real rest_height{};
    /// Touching bodies that approach more slowly than the rest speed, but faster than `sink_speed`,
    /// meet once they overlap by `sink_depth`. Without that they could sink in for as long as their
    /// trajectories last. Length and length/s; depth 0 switches the rule off.
    Real sink_depth{};
    Real sink_speed{};
    std::uint64_t weight = 1;  ///< of an iteration, in ToiSearch::iterations

    bool has_sunk(const Separation<Real>& now) const {
        return sink_depth > Real{} && now.distance <= -sink_depth && now.velocity < -sink_speed;
    }

    Real rest_speed_at(const Separation<Real>& now) const {
        const bool is_pressed = rest_height > Real{} && now.normal_acceleration < Real{};
        if (!is_pressed) return rest_speed;
        const Real pressed = square_root(rest_height * -now.normal_acceleration);
        return rest_speed < pressed ? pressed : rest_speed;
    }
};

/// Advancement of bodies that touch and do not approach noticeably: a time, s, within which no
/// noticeable approach can begin.
///
/// The acceleration bound alone allows steps of rest_speed / bound. Far longer steps are safe where
/// the normal hardly turns: it turns by less than m in a time of m d / 2 v, and in sqrt(m d /
/// bound), with d the distance of the centres and v the relative speed. For that long the
/// acceleration of the separation is at least normal_acceleration - m bound. The function tries a
/// few values of m and takes the best.
///
/// Bodies that part reach their distance again after 2 v / bound. Bodies that overlap by more than
/// `slop` meet earlier if they get out of one another: where they touch on the way back. An
/// acceleration below the bound may let them out where the bound would not. The one that just lets
/// them out brings them back the soonest: after 2 depth / v.
///
/// Where bodies may sink in only so far (ToiTolerance::sink_depth), it also takes no longer than
/// until they are as deep, and approach.
template <typename Real>
Real touching_step(const Separation<Real>& now, const Real& acceleration_bound,
                   const Real& rest_speed, const ToiTolerance<Real>& tolerance) {
    const Real& slop = tolerance.slop;
    const auto until_sunk = [&](const Real& against) {
        const Real room = now.distance + tolerance.sink_depth;
        if (!(room > Real{})) return (now.velocity + tolerance.sink_speed) / against;
        const Real speed = square_root(now.velocity * now.velocity + Real(2.0) * against * room);
        return now.velocity < Real{} ? Real(2.0) * room / (speed - now.velocity)
                                     : (now.velocity + speed) / against;
    };
    const auto until_approach = [&](const Real& against) {
        if (!(now.velocity > rest_speed)) {
            const Real time = (now.velocity + rest_speed) / against;
            return tolerance.sink_depth > Real{} ? std::min(time, until_sunk(against)) : time;
        }
        const Real back = Real(2.0) * now.velocity / against;
        if (!(now.distance < -Real(4.0) * slop)) return back;
        const Real outside = now.velocity * now.velocity + Real(2.0) * against * now.distance;
        if (outside > Real{}) return (now.velocity + square_root(outside)) / against;
        return std::min(back, Real(-2.0) * now.distance / now.velocity);
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
        } else if (tolerance.sink_depth > Real{} && now.velocity < -tolerance.sink_speed) {
            const Real reach = (now.distance + tolerance.sink_depth) / -now.velocity;
            if (reach < step) step = reach;
        }
        if (best < step) best = step;
    }
    return best;
}

/// Time of impact, >= 0, of bodies whose distance is exactly
/// distance + velocity t + acceleration t^2 / 2, in closed form: no term cancels.
///
/// Bodies that touch and approach faster than `rest_speed`: 0. Bodies that touch, are leaving or at
/// rest, and are accelerated towards each other: the time at which they approach noticeably again.
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

/// State shared by many searches: the iterations they took, and the earliest time at which a
/// suspended search must resume.
///
/// A search that takes too many iterations is suspended: it reports no impact and notes the time
/// that it has cleared. The caller repeats the search at that time, from the original beginning. So
/// no impact is passed over, and the result does not depend on how often a search was suspended. A
/// caller that repeats it from a later beginning gets other roundings.
template <typename Real>
struct ToiSearch {
    /// Iterations that one search may take after `now` before it is suspended. A repeated search
    /// gets as many as it needs to reach `now`, so all repetitions together cost no more than a few
    /// times one search.
    static constexpr std::uint32_t most_iterations = 65536;

    Real now{};  ///< every search clears the time up to here before it is suspended, s
    std::optional<Real> resume_time;  ///< the earliest time that a suspended search has cleared, s
    std::uint64_t iterations = 0;     ///< of all searches, each by its weight

    /// Searches that follow start at `time`.
    void begin_at(const Real& time) {
        now = time;
        resume_time.reset();
    }
    void suspend(const Real& time) {
        if (!resume_time || time < *resume_time) resume_time = time;
    }
};

/// Time of impact in begin..end of bodies on arbitrary trajectories, by conservative advancement.
///
/// `separation_at(t)`: the separation at time t. `acceleration_bound`, length/s^2, >= 0: while the
/// bodies are apart, the second derivative of their distance is nowhere below its negative. Where
/// Separation::acceleration_bound is far sharper, for example for bodies that move side by side,
/// the search uses that bound instead.
///
/// Method: after s seconds the distance is at least
///
///     distance + velocity s - bound s^2 / 2
///
/// so its first root is a step that cannot pass over an impact; near the impact the steps shrink
/// quadratically. The result is the first time at which the distance is at most `slop` and shrinks
/// faster than the rest speed, or at which the bodies have sunk in (ToiTolerance::sink_depth). It
/// is late by no more than rounding, and no impact is passed over whose depth would reach 4 slop. A
/// separation that turns back before is a graze, not an impact. No result: there is no impact until
/// `end`, or the search was suspended and `search` holds its resume time.
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
        search.iterations += tolerance.weight;
        const bool is_sharper = !(now.acceleration_bound < zero) &&
                                Real(64.0) * now.acceleration_bound < acceleration_bound;
        const Real& bound = is_sharper ? now.acceleration_bound : acceleration_bound;
        Real step{};
        if (now.distance <= tolerance.slop) {
            const bool grazes =
                now.acceleration > zero &&
                now.velocity * now.velocity < Real(8.0) * now.acceleration * tolerance.slop;
            const Real rest_speed = tolerance.rest_speed_at(now);
            if ((now.velocity < -rest_speed || tolerance.has_sunk(now)) && !grazes) return time;
            if (!(bound > zero)) return std::nullopt;
            if (grazes && now.velocity < zero)
                step = Real(-2.0) * now.velocity / now.acceleration;
            else
                step = touching_step(now, bound, rest_speed, tolerance);
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
