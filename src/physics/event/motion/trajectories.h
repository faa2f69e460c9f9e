#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/event/motion/ball_table.h"
#include "physics/event/motion/scene.h"
#include "physics/event/motion/spatial_index.h"
#include "physics/event/motion/trajectory.h"

namespace carom {

/// How a ball spins about the vertical axis: `spin` at `time`, rad/s counter-clockwise, and its
/// rate of change since, rad/s^2.
template <typename Real>
struct SpinTrajectory {
    Real time{};
    Real spin{};
    Real rate{};
    bool rolls = false;  ///< it rolls along a side without slip
};

/// The trajectory of every ball, and of its spin: the part that starts them.
///
/// A trajectory starts at an event and holds until the ball's next one that changes it. Neither the
/// end of a tick nor a cell transfer starts one, but for what README.md lists. Every start
/// increments BallRecord::version, which voids all predictions that were made with the old
/// trajectory. WorldSync sets trajectories without that when a tick rebuilds, and everything is
/// predicted afterwards.
template <typename Real>
class Trajectories {
  public:
    Trajectories(const EventScene<Real>& scene, BallTable<Real>& balls, SpatialIndex<Real>& space)
        : scene_(scene), balls_(balls), space_(space) {}

    /// A ball in free flight from `time` on, with its present spin. On a torus the trajectory
    /// starts in the frame: the position may be moved by whole periods.
    void start(std::uint32_t ball, const Real& time, Vector<Real> position,
               const Vector<Real>& velocity);
    /// `start` at the present time, for scenes of uniform motion, where nothing curves or wraps.
    [[gnu::always_inline]] void start_straight(std::uint32_t ball, const Vector<Real>& position,
                                               const Vector<Real>& velocity,
                                               std::uint32_t recent_collisions) {
        BallRecord<Real>& each = balls_[ball];
        each.line.recent_collisions = recent_collisions;
        each.line.time = scene_.now;
        each.line.position = position;
        each.line.velocity = velocity;
        ++each.version;
        log_start(ball);
    }
    /// The trajectory that has just started is that of a kinematic ball: uniform motion.
    void hold(std::uint32_t ball);
    /// The trajectory that has just started is one of rest on these supports.
    void put_to_rest(std::uint32_t ball, const SupportId& support, const SupportId& second_support);

    /// Where the ball is now, and how fast.
    BallState<Real> state_now(std::uint32_t ball) const {
        return state_at(balls_.trajectory(ball), scene_.field, scene_.now);
    }
    Vector<Real> position_now(std::uint32_t ball) const {
        const LinearPart<Real>& line = balls_[ball].line;
        if (line.motion == Motion::free && !scene_.field.has_drag) {
            const Real since = scene_.now - line.time;
            return line.position +
                   (line.velocity + scene_.field.gravity * (Real(0.5) * since)) * since;
        }
        const Trajectory<Real> trajectory = balls_.trajectory(ball);
        return is_parabola(trajectory, scene_.field)
                   ? parabola_at(trajectory, scene_.now)
                   : state_at(trajectory, scene_.field, scene_.now).position;
    }
    /// Where World::balls shows a position: on a torus, in the frame.
    Vec2 shown_position(const Trajectory<Real>& trajectory, const Real& time) const;

    /// Pre, for all that concerns spin: Model::spin.
    SpinTrajectory<Real>& spin(std::uint32_t ball) { return spins_[ball]; }
    const SpinTrajectory<Real>& spin(std::uint32_t ball) const { return spins_[ball]; }
    Real spin_at(std::uint32_t ball, const Real& time) const;
    /// From `time` on the ball spins on as it does then.
    void continue_spin(std::uint32_t ball, const Real& time);
    /// All spins, by ball; empty unless Model::spin.
    std::vector<SpinTrajectory<Real>>& spins() { return spins_; }
    const std::vector<SpinTrajectory<Real>>& spins() const { return spins_; }

    /// The roll on cloth (laws/cloth.h): 0 for a ball that lies still or is held.
    /// Pre: Model::cloth.
    Vector<Real> roll_at(std::uint32_t ball, const Real& time) const;

    /// The balls whose trajectories started since `begin_log`, with repetitions; as many entries as
    /// balls: all of them.
    std::span<const std::uint32_t> started() const { return started_; }
    /// `keeps`: whether starts are to be logged at all.
    void begin_log(bool keeps) {
        started_.clear();
        keeps_log_ = keeps;
    }
    void reserve_log(std::size_t count) { started_.reserve(count); }

    /// Whether every ball flies straight, so that UniformMotion handles its events.
    bool are_all_straight() const { return are_all_straight_; }
    void set_all_straight(bool are) { are_all_straight_ = are; }

    /// How often a start has moved a trajectory by whole periods: image indices that were found
    /// before such a move no longer hold.
    std::uint64_t image_changes() const { return image_changes_; }

  private:
    void log_start(std::uint32_t ball) {
        if (keeps_log_ && started_.size() < balls_.size()) started_.push_back(ball);
    }

    const EventScene<Real>& scene_;
    BallTable<Real>& balls_;
    SpatialIndex<Real>& space_;
    std::vector<SpinTrajectory<Real>> spins_;
    std::vector<std::uint32_t> started_;
    bool keeps_log_ = false;
    bool are_all_straight_ = false;
    std::uint64_t image_changes_ = 0;
};

}  // namespace carom
