#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "physics/event/motion/ball_impact.h"
#include "physics/event/motion/ball_table.h"
#include "physics/event/motion/event.h"
#include "physics/event/motion/scene.h"
#include "physics/event/motion/spatial_index.h"
#include "physics/memory/branchless.h"

/// Collisions of balls that fly: the part of the predictor in which a gas spends nearly all its
/// time, and therefore defined here and compiled for the terms that a scene has.
namespace carom {

/// Which terms of motion predictions are compiled for.
enum class MotionTerms : std::uint8_t {
    any,
    uniform,  ///< every ball is in uniform motion and collides with every other: uniform_motion.h
};

/// The ball that a ball meets first. Passed by value, in registers: a value that was written to
/// memory in parts and is read as a whole stalls the processor.
template <typename Real>
struct FirstCollision {
    Real time{std::numeric_limits<double>::infinity()};  ///< s
    std::uint32_t other = BallRecord<Real>::none;
    std::uint32_t version = 0;  ///< the other's
    std::int8_t across = 0;     ///< image of the other, as in BallEvent
    std::int8_t along = 0;

    FirstCollision() = default;
    /// Pre: a collision that is known, or none.
    explicit FirstCollision(const BallEvent<Real>& collision) {
        if (collision.kind == EventKind::none) return;
        time = collision.time;
        other = collision.other;
        version = collision.other_version;
        across = collision.across;
        along = collision.along;
    }
    BallEvent<Real> event() const {
        const bool is_one = other != BallRecord<Real>::none;
        return {time,   is_one ? EventKind::ball_ball : EventKind::none, across, along, other,
                version};
    }
};

/// The balls near another one, and which of them it approaches so as to meet.
template <typename Real>
struct NearBalls {
    static constexpr std::size_t most = 64;
    std::array<std::uint32_t, most> other;
    std::array<Vector<Real>, most> offset;  ///< from its centre, now
    std::array<StraightApproach<Real>, most> approach;
    std::array<std::uint32_t, most> approached;  ///< indices
    std::size_t approached_count = 0;
};

/// Finds the first collision of a ball that flies: moves freely, and without drag. Two such balls
/// see one another move uniformly, so the time is known however far ahead it is.
template <typename Real>
class ForeseenCollisions {
  public:
    ForeseenCollisions(const EventScene<Real>& scene, const BallTable<Real>& balls,
                       const SpatialIndex<Real>& space)
        : scene_(scene), balls_(balls), space_(space) {}

    bool is_flying(std::uint32_t ball) const {
        return balls_[ball].line.motion == Motion::free && !scene_.field.has_drag;
    }
    /// Whether the ball's first collision can be known, if the balls around it fly too. One-way
    /// edges are tested whenever all is predicted anew, so that must happen at every cell.
    bool can_foresee(std::uint32_t ball) const {
        return is_flying(ball) && space_.cells().oversized().empty() &&
               !scene_.world->model().one_way;
    }

    /// BallCells::for_each_near and for_each_new; in uniform motion nothing wraps.
    template <MotionTerms terms, typename Visit>
    void for_each_near(std::uint32_t ball, Visit&& visit) const {
        if constexpr (terms == MotionTerms::any)
            return space_.cells().for_each_near(balls_, ball, visit);
        auto chains = space_.cells().chains_near(balls_, ball);
        chains.for_each(balls_.data(), visit);
    }
    template <MotionTerms terms, typename Visit>
    void for_each_new(std::uint32_t ball, int columns, int rows, Visit&& visit) const {
        if constexpr (terms == MotionTerms::any)
            return space_.cells().for_each_new(balls_, ball, columns, rows, visit);
        auto chains = space_.cells().chains_of_new(balls_, ball, columns, rows);
        chains.for_each(balls_.data(), visit);
    }

    /// The earlier of `best` and the collision with `other`, if there is one. `across`, `along`:
    /// the image of the other, as in BallEvent. Pre: both balls fly.
    template <MotionTerms terms>
    FirstCollision<Real> earlier(std::uint32_t ball, std::uint32_t other, int across, int along,
                                 FirstCollision<Real> best) const;
    /// `earlier` where the approach is known, from `offset` at the time `begin`. Pre: it is an
    /// impact.
    template <MotionTerms terms>
    FirstCollision<Real> earlier(std::uint32_t ball, std::uint32_t other, int across, int along,
                                 const StraightApproach<Real>& approach, const Real& begin,
                                 const Vector<Real>& offset, FirstCollision<Real> best) const;

  private:
    const EventScene<Real>& scene_;
    const BallTable<Real>& balls_;
    const SpatialIndex<Real>& space_;
};

template <typename Real>
template <MotionTerms terms>
inline FirstCollision<Real> ForeseenCollisions<Real>::earlier(std::uint32_t ball,
                                                              std::uint32_t other, int across,
                                                              int along,
                                                              FirstCollision<Real> best) const {
    if (terms == MotionTerms::any && !scene_.balls_collide(ball, other)) return best;
    const BallRecord<Real>& us = balls_[ball];
    const BallRecord<Real>& them = balls_[other];
    const auto pair = [&] {
        if constexpr (terms == MotionTerms::uniform)
            return StraightPair<Real>(us.line, them.line);
        else
            return StraightPair<Real>(us.line, them.line, scene_.field.gravity,
                                      scene_.image_shift(across, along));
    }();
    const StraightApproach<Real> approach(pair.offset, pair.velocity, us.radius + them.radius);
    return approach.is_impact()
               ? earlier<terms>(ball, other, across, along, approach, pair.begin, pair.offset, best)
               : best;
}

// Without a branch on which comes first, since no processor can predict it.
template <typename Real>
template <MotionTerms terms>
inline FirstCollision<Real> ForeseenCollisions<Real>::earlier(
    std::uint32_t ball, std::uint32_t other, int across, int along,
    const StraightApproach<Real>& approach, const Real& begin, const Vector<Real>& offset,
    FirstCollision<Real> best) const {
    const BallRecord<Real>& us = balls_[ball];
    const BallRecord<Real>& them = balls_[other];
    const Real small = us.radius < them.radius ? us.radius : them.radius;
    const Vector<Real> gravity =
        terms == MotionTerms::uniform ? Vector<Real>{} : scene_.field.gravity;
    // Computed as seen from the lower ball, so that both balls find the same bits.
    const auto met = straight_time_of_impact(approach, balls_[std::min(ball, other)].line,
                                             balls_[std::max(ball, other)].line, begin, offset,
                                             gravity, us.radius + them.radius, small, scene_.field);
    if (!met) return best;
    const Real time = *met < scene_.now ? scene_.now : *met;
    bool comes = time < best.time;
    if (time == best.time)
        comes = comes_before<Real>(ball, {time, EventKind::ball_ball, 0, 0, other, 0}, ball,
                                   {best.time, EventKind::ball_ball, 0, 0, best.other, 0});
    best.time = time < best.time ? time : best.time;
    best.other = select(comes, other, best.other);
    best.version = select(comes, them.version, best.version);
    if constexpr (terms == MotionTerms::any) {
        best.across = comes ? static_cast<std::int8_t>(across) : best.across;
        best.along = comes ? static_cast<std::int8_t>(along) : best.along;
    }
    return best;
}

}  // namespace carom
