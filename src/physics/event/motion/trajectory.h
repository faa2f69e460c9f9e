#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "geometry/vector.h"
#include "physics/event/motion/event_memory.h"
#include "physics/world/world.h"

/// How a ball moves between two events of the solver `event`: exactly, in closed form or by a
/// series that is exact to rounding.
///
/// Units: length, length/s, s. Real: double, or DoubleDouble for the reference. World stores the
/// trajectories of doubles (event_memory.h) and says what each part means.
namespace carom {

/// The part of a trajectory that a ball in uniform motion needs.
template <typename Real>
struct LinearPart {
    std::uint32_t recent_collisions = 0;  ///< see collapse_guard.h
    Motion motion = Motion::free;
    /// Periodic image in which the ball is now, relative to the image in which the trajectory
    /// starts. BallCells counts them.
    std::int8_t across = 0;
    std::int8_t along = 0;
    Real time{};  ///< when it starts
    Vector<Real> position;
    Vector<Real> velocity;
};

/// LinearPart::recent_collisions after one more, as far as StoredLinearPart can count.
inline std::uint32_t one_more(std::uint32_t collisions) {
    return std::min<std::uint32_t>(collisions + 1, std::numeric_limits<std::uint16_t>::max());
}

/// The part that curves it.
template <typename Real>
struct AccelerationPart {
    Vector<Real> acceleration;
    Vector<Real> center;  ///< of the circle (Motion::turning); on cloth, the roll at `time`
    SupportId support;
    SupportId second_support;

    friend bool operator==(const AccelerationPart&, const AccelerationPart&) = default;
};

template <typename Real>
struct Trajectory : LinearPart<Real>, AccelerationPart<Real> {};

template <typename Real>
struct BallState {
    Vector<Real> position;
    Vector<Real> velocity;
};

/// What acts on every ball.
template <typename Real>
struct Field {
    Vector<Real> gravity;
    Real drag{};  ///< 1/s; 0: none
    bool has_drag = false;
    /// The length of gravity if the scene loses energy, so that balls come to be pressed together;
    /// else 0. Not a force: thresholds for pressed bodies scale with it. length/s^2.
    Real pressing{};
};

/// The field of a model. Models with 0 and with -0 give the same bits.
template <typename Real>
Field<Real> field_of(const Model& model);

/// Position and velocity at `time`.
/// Pre: time >= trajectory.time; for Motion::turning, time <= piece_end(trajectory, field).
template <typename Real>
BallState<Real> state_at(const Trajectory<Real>& trajectory, const Field<Real>& field,
                         const Real& time);

/// The position at `time` on a parabola: see `is_parabola`.
template <typename Real>
inline Vector<Real> parabola_at(const Trajectory<Real>& trajectory, const Real& time) {
    const Real since = time - trajectory.time;
    return trajectory.position +
           (trajectory.velocity + trajectory.acceleration * (Real(0.5) * since)) * since;
}

/// Whether the trajectory is a parabola: drag does not act on it, and it does not turn.
template <typename Real>
inline bool is_parabola(const Trajectory<Real>& trajectory, const Field<Real>& field) {
    return trajectory.motion != Motion::turning &&
           (!field.has_drag || trajectory.motion == Motion::held);
}

/// Whether the ball lies on cloth and nothing holds it.
template <typename Real>
inline bool is_on_cloth(const LinearPart<Real>& line) {
    return line.motion >= Motion::slipping;
}

/// A bound on the length of the acceleration, length/s^2, from `time` on; for Motion::turning until
/// the end of the piece. It depends on no horizon, so neither do the impacts that are found by it,
/// unless an edge moves (edge_impact.h).
template <typename Real>
Real most_acceleration(const Trajectory<Real>& trajectory, const Field<Real>& field,
                       const Real& time);

/// A ball that slides without friction round a round end, a peg or another ball is a pendulum. Its
/// angle is a Taylor series in time, valid for one *piece*: until the angle could have changed by
/// `most_piece_angle`.
template <typename Real>
struct Turn {
    Real radius{};        ///< of the circle of the ball's centre, length
    Vector<Real> normal;  ///< from the centre of the circle to the ball, unit
    Real speed{};         ///< along perpendicular(normal), length/s
    Real press{};  ///< acceleration that presses it on, length/s^2; negative: it leaves the circle
};
template <typename Real>
Turn<Real> turn_at(const Trajectory<Real>& trajectory, const Field<Real>& field, const Real& time);

/// When the piece ends, s: a function of the trajectory alone.
template <typename Real>
Real piece_end(const Trajectory<Real>& trajectory, const Field<Real>& field);

}  // namespace carom
