#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "geometry/wide.h"

/// When a gap closes: the root finders of the solver `event`. Only the first moment counts at which
/// a gap goes from positive to negative; a gap that opens, stays or merely touches zero has none.
/// So an impact that has been dealt with is never found again.
namespace carom {

/// A gap between two bodies at one moment.
template <typename Real>
struct Gap {
    Real gap;   ///< length; negative is depth of overlap
    Real rate;  ///< length/s
    /// Second derivative, length/s^2.
    Real bend;
    /// The part of it that is the relative acceleration along the normal, length/s^2, and what
    /// turns the normal: speed, length/s, over distance, length. All 0: not known.
    Real lean{};
    Real speed{};
    Real distance{};
    /// The second derivative is nowhere below -pull from now on, length/s^2; < 0: not known.
    Real pull{-1.0};
};

/// A safe step for bodies that touch and do not approach noticeably. The normal turns by less than
/// m in a time of m d / 2 v and of sqrt(m d / pull), so for that long the gap bends by no less than
/// lean - m pull: the best of a few m is far longer than what the pull alone, with any direction,
/// would allow.
template <typename Real>
Real touching_step(const Gap<Real>& now, const Real& pull, const Real& slow) {
    const auto way = [&](const Real& against) {
        return (now.rate > slow ? now.rate + now.rate : now.rate + slow) / against;
    };
    Real best = way(pull);
    if (!(now.distance > Real{})) return best;
    for (const double turn : {0.125, 0.01, 0.001}) {
        const Real m(turn);
        Real limit = square_root(m * now.distance / pull);
        if (now.speed * limit > m * now.distance * Real(0.5))
            limit = m * now.distance * Real(0.5) / now.speed;
        const Real against = m * pull - now.lean;
        Real step = limit;
        if (against > Real{}) {
            const Real reach = way(against);
            if (reach < step) step = reach;
        }
        if (best < step) best = step;
    }
    return best;
}

/// What counts as touching and as rounding.
template <typename Real>
struct ClosingTolerance {
    Real touch;  ///< length: gaps up to this touch
    Real slow;   ///< length/s: bodies that touch and approach more slowly than this have no impact
    /// The same of bodies that are pressed together (Gap::lean): more slowly than in a fall through
    /// half of this with what presses them, length. 0: no more than that.
    Real rise{};

    Real slow_at(const Gap<Real>& now) const {
        if (!(rise > Real{}) || !(now.lean < Real{})) return slow;
        const Real pressed = square_root(rise * -now.lean);
        return slow < pressed ? pressed : slow;
    }
};

/// First time >= 0 at which gap + rate t + bend t^2 / 2 goes from positive to negative. Exact to
/// rounding: no term cancels. A gap that touches and closes faster than `slow`: 0.
template <typename Real>
std::optional<Real> quadratic_closing(const Gap<Real>& now,
                                      const ClosingTolerance<Real>& tolerance) {
    const Real zero{};
    if (now.gap <= tolerance.touch) {
        const Real& slow = tolerance.slow;
        if (now.rate < -slow) return zero;
        if (!(now.bend < zero)) return std::nullopt;
        // Touching: out and back, or pressed together until they approach noticeably.
        if (now.rate > slow) return (now.rate + now.rate) / -now.bend;
        return (now.rate + slow) / -now.bend;
    }
    const Real discriminant = now.rate * now.rate - Real(2.0) * now.bend * now.gap;
    if (now.rate < zero) {
        if (!(discriminant > zero)) return std::nullopt;
        return Real(2.0) * now.gap / (square_root(discriminant) - now.rate);
    }
    if (!(now.bend < zero)) return std::nullopt;
    return (now.rate + square_root(discriminant)) / -now.bend;
}

/// The work of many searches, and how far those came that were not finished. Whoever looks on must
/// begin them anew once that time has come, as they began before: nothing is passed over then, and
/// nothing that is found depends on how often a search was left off.
template <typename Real>
struct ClosingSearch {
    /// Looks of one search after `now`, until it is left off; or as many as it took until `now`,
    /// so that all of them together are no more than a few times those of one search.
    static constexpr std::uint32_t most_looks = 65536;

    Real now{};                   ///< searches go on until later than this
    std::optional<Real> reached;  ///< until when nothing closes, of the search that came least far
    std::uint64_t looks = 0;      ///< of all searches

    void begin_at(const Real& time) {
        now = time;
        reached.reset();
    }
    void leave_off(const Real& time) {
        if (!reached || time < *reached) reached = time;
    }
};

/// First time in begin..end at which a gap of any shape closes. look(t) gives the gap at a time;
/// its second derivative is nowhere below -pull while the gap is open, nor below what look says,
/// which is asked where it is far sharper: of bodies that move side by side.
///
/// Method: gap + rate s - pull s^2 / 2 is a lower bound, so its first root is a safe step; near the
/// end the steps shrink quadratically. The result is the first time at which the gap is at most
/// `touch` and closes faster than `slow`: it is late by no more than rounding, and no impact is
/// passed over whose depth would reach `touch`. A gap that bends away before its overlap would
/// reach 4 touch only grazes. A search that takes too many looks says so to `search`, and
/// finds nothing.
template <typename Real, typename Look>
std::optional<Real> first_closing(Look&& look, Real begin, Real end, Real pull,
                                  const ClosingTolerance<Real>& tolerance,
                                  ClosingSearch<Real>& search) {
    const Real zero{};
    Real time = begin;
    std::uint32_t past = 0;
    std::uint32_t looks = 0;
    while (looks < std::max(past, ClosingSearch<Real>::most_looks)) {
        const Gap<Real> now = look(time);
        ++search.looks;
        const bool is_sharper = !(now.pull < zero) && Real(64.0) * now.pull < pull;
        const Real& most = is_sharper ? now.pull : pull;
        Real step{};
        if (now.gap <= tolerance.touch) {
            const bool grazes =
                now.bend > zero && now.rate * now.rate < Real(8.0) * now.bend * tolerance.touch;
            const Real slow = tolerance.slow_at(now);
            if (now.rate < -slow && !grazes) return time;
            if (!(most > zero)) return std::nullopt;
            if (grazes && now.rate < zero)
                step = Real(-2.0) * now.rate / now.bend;
            else
                step = touching_step(now, most, slow);
        } else if (now.rate < zero) {
            step = Real(2.0) * now.gap /
                   (square_root(now.rate * now.rate + Real(2.0) * most * now.gap) - now.rate);
        } else {
            if (!(most > zero)) return std::nullopt;
            step =
                (now.rate + square_root(now.rate * now.rate + Real(2.0) * most * now.gap)) / most;
        }
        const Real least = Real(precision<Real>) * absolute(time);
        time += step > least ? step : least;
        if (!(time <= end)) return std::nullopt;
        ++(search.now < time ? looks : past);
    }
    search.leave_off(time);
    return std::nullopt;
}

}  // namespace carom
