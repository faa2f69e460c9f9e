#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/shapes.h"
#include "physics/ccd/chord.h"
#include "physics/laws/cloth.h"
#include "physics/memory/large_pages.h"
#include "physics/swept/substep.h"

namespace carom {

/// A ball in a substep: its chord, at the mean velocity, and the real velocity with which the
/// flight or slide along it began. It fills one cache line, since memory access is what a gas of
/// many balls costs.
struct alignas(64) SweptPath {
    Chord chord;
    Vec2 start_velocity;  ///< of the parabola, at chord.time; of a frozen ball, at the end
    std::uint32_t version : 28 = 0;     ///< counts its changes of path
    std::uint32_t is_frozen : 1 = 0;    ///< until the substep ends
    std::uint32_t is_standing : 1 = 0;  ///< frozen, and keeps its velocity: time stands still
    std::uint32_t is_grounded : 1 = 0;  ///< rests on something that does not give way
    std::uint32_t is_resting : 1 = 0;   ///< has resting contacts
    std::uint32_t resting_impacts = 0;
};

/// The resting contacts of a ball.
struct SweptRest {
    Vec2 gravity;  ///< the rest of gravity that the supports do not bear, and friction, length/s^2
    Vec2 borne;    ///< against the part of gravity that the supports bear, length/s^2
    Vec2 support;  ///< normals of the last two supports, 0 where there is none
    Vec2 other_support;
};

/// Where every ball is within a substep of the solver `swept`, and how fast.
///
/// A path is the chord of the parabola from where a ball is to where free motion takes it by the
/// end of the substep. So free flight is exact, and an impact is early or late by at most g h^2 / 8
/// of height. The velocity at an impact is that of the parabola at the height of the chord, so an
/// elastic bounce conserves energy to rounding. On cloth the path is the chord of the exact motion
/// through sliding, rolling and rest.
///
/// A ball that rests on something immovable feels only the gravity along it. A held ball goes
/// straight to its target. A frozen ball stays where it is until the substep ends:
/// - after too many resting impacts it has come to rest, and loses its velocity, since bounces that
///   lose energy end in rest;
/// - in an elastic scene, and beyond the budget of work (tick/work_budget.h), time stands still for
///   it: it keeps velocity, spin and roll.
///
/// Positions and velocities in the world are those of the start of the substep until `finish`; spin
/// and roll in the world are those at the time of a ball's last change of path.
class SweptPaths {
  public:
    explicit SweptPaths(const SweptSubstep& step) : step_(step) {}

    /// Reads the masses for a tick.
    void begin_tick(const World& world);
    /// Begins a substep, in which held balls cover `share_of_displacement` of the rest of their
    /// displacements.
    void begin(const World& world, double share_of_displacement);
    /// Lets time stand still for all balls that would go far (division.h). To follow `begin`.
    void stop_far_balls(const World& world);
    /// Ends the substep: writes positions, velocities, spin and roll to the world.
    void finish(World& world) const;

    std::size_t size() const { return paths_.size(); }
    const SweptPath& operator[](std::uint32_t ball) const { return paths_[ball]; }
    /// 0: held. 1/mass.
    const double& inverse_mass(std::uint32_t ball) const { return inverse_mass_[ball]; }
    bool is_held(std::uint32_t ball) const { return inverse_mass_[ball] == 0.0; }
    /// Pre: it is resting.
    const SweptRest& rest(std::uint32_t ball) const { return resting_[ball]; }

    Vec2 position_at(std::uint32_t ball, double now) const {
        return paths_[ball].chord.position_at(now);
    }
    /// Velocity on the parabola where it is as high as the chord is now.
    Vec2 velocity_at(const World& world, std::uint32_t ball, double now) const;
    /// Velocity along the chord of the motion that would start now at `velocity`. Pre: the ball is
    /// neither held nor frozen.
    Vec2 chord_velocity(const World& world, std::uint32_t ball, Vec2 velocity, Vec2 gravity,
                        double now) const;
    Vec2 gravity_on(std::uint32_t ball) const {
        return paths_[ball].is_resting ? resting_[ball].gravity : step_.gravity;
    }
    /// A disc, and a box, that hold everything that the ball can touch from now to the end of the
    /// substep.
    Disc bounding_disc(const World& world, std::uint32_t ball, double now) const {
        const Vec2 half = paths_[ball].chord.velocity * (0.5 * (step_.duration - now));
        const Vec2 center = position_at(ball, now) + half;
        // Wider by more than rounding takes.
        constexpr double hair = 1e-14;
        const double size = std::fabs(center.x) + std::fabs(center.y);
        return {center, world.balls().radius[ball] + length(half) + hair * size};
    }
    Box bounding_box(const World& world, std::uint32_t ball, double now) const {
        const Vec2 from = position_at(ball, now);
        const Vec2 to = from + paths_[ball].chord.velocity * (step_.duration - now);
        return grow(join({from, from}, {to, to}), world.balls().radius[ball]);
    }

    /// Starts a new path from where the ball is now, at first at `velocity`; a frozen ball ignores
    /// that. Predictions along its old path become void. Returns whether this is its first change
    /// of path in the substep.
    bool redirect(const World& world, std::uint32_t ball, double now, Vec2 velocity);
    /// Counts a resting impact, which the ball leaves at `velocity`, and freezes it after too many.
    void count_resting_impact(const World& world, std::uint32_t ball, Vec2 velocity);
    /// Time stands still for the ball from `now` on; `redirect` must follow. Pre: it is not frozen.
    void stand_still(World& world, std::uint32_t ball, double now);
    /// The balls for which time has stood still in this tick, with repetitions.
    std::span<const std::uint32_t> standing() const { return standing_; }
    /// The ball has come to rest on something immovable; `normal` points from there to the ball. On
    /// a seesaw, which turns, it follows the surface at the acceleration `follow` along the normal.
    void rest_on(const World& world, std::uint32_t ball, Vec2 normal, double follow = 0.0);
    /// A bounce has taken the ball off what it rested on.
    void end_rest(std::uint32_t ball) {
        SweptPath& path = paths_[ball];
        path.is_resting = false;
        path.is_grounded = path.is_frozen;
        if (!spin_rate_.empty()) spin_rate_[ball] = 0.0;
    }

    // Turning: spin.cpp. Pre, for all of these: Model::spin.

    /// Advances spin, and roll on cloth, to `now` in the world.
    void advance_spin(World& world, std::uint32_t ball, double now) const;
    /// Applies the friction that the weight of a ball causes on an edge on which it has just come
    /// to rest; `surface` is the velocity of the edge's surface. Friction is a constant
    /// acceleration for the rest of the substep: enough to stop the slip by then, with gravity
    /// along the edge, but no more than `coefficient` allows. So a rolling ball accelerates by
    /// g sin / (1 + inertia), and the end of a slip is rounded to a substep. Where two edges share
    /// the weight, friction brakes the spin alone.
    void apply_rest_friction(World& world, std::uint32_t ball, Vec2 surface, double coefficient,
                             double now, Vec2& velocity);
    /// A ball on cloth that is pressed `most_resting_impacts` times in a substep rolls at once as
    /// it would after the slip.
    void stop_sliding_if_pressed(World& world, std::uint32_t ball, Vec2& velocity) const;

  private:
    void mark_standing(std::uint32_t ball);
    ClothState<double> on_cloth(const World& world, std::uint32_t ball, Vec2 velocity,
                                double duration) const;
    void finish_turning(World& world, std::uint32_t ball, double since) const;

    const SweptSubstep& step_;
    LargeVector<SweptPath> paths_;
    std::vector<SweptRest> resting_;  // of the balls that rest; empty without gravity
    std::vector<double> inverse_mass_;
    std::vector<double> spin_rate_;  // rad/s^2 since the path's time; empty unless Model::spin
    std::vector<std::uint32_t> standing_;
};

}  // namespace carom
