#include "physics/event/motion/trajectories.h"

#include "physics/broad_phase/capsule_cells.h"
#include "physics/laws/cloth.h"

namespace carom {

template <typename Real>
void Trajectories<Real>::start(std::uint32_t ball, const Real& time, Vector<Real> position,
                               const Vector<Real>& velocity) {
    if (scene_.world->model().wrap) {
        const Vec2 shown(position);
        const Vec2 inside = wrapped(shown, *scene_.world->model().wrap);
        const auto periods = [](double distance, double period) {
            return static_cast<int>(distance / period + (distance < 0.0 ? -0.5 : 0.5));
        };
        const int across = periods(inside.x - shown.x, scene_.period.x);
        const int along = periods(inside.y - shown.y, scene_.period.y);
        if (across != 0 || along != 0) {
            position += scene_.image_shift(across, along);
            space_.cells().shift(balls_, ball, across, along);
            ++image_changes_;
        }
    }
    if (scene_.world->model().spin) continue_spin(ball, time);
    LinearPart<Real>& line = balls_[ball].line;
    line = {.across = line.across,
            .along = line.along,
            .time = time,
            .position = position,
            .velocity = velocity};
    if (balls_.may_curve()) balls_.curve(ball) = {.acceleration = scene_.field.gravity};
    ++balls_[ball].version;
    log_start(ball);
}

template <typename Real>
void Trajectories<Real>::hold(std::uint32_t ball) {
    balls_[ball].line.motion = Motion::held;
    if (balls_.may_curve()) balls_.curve(ball).acceleration = {};
}

template <typename Real>
void Trajectories<Real>::put_to_rest(std::uint32_t ball, const SupportId& support,
                                     const SupportId& second_support) {
    Trajectory<Real> trajectory = balls_.trajectory(ball);
    trajectory.motion = Motion::resting;
    trajectory.velocity = trajectory.acceleration = {};
    trajectory.support = support;
    trajectory.second_support = second_support;
    balls_.set_trajectory(ball, trajectory);
}

template <typename Real>
Vec2 Trajectories<Real>::shown_position(const Trajectory<Real>& trajectory,
                                        const Real& time) const {
    const Vec2 position(state_at(trajectory, scene_.field, time).position);
    return scene_.world->model().wrap ? wrapped(position, *scene_.world->model().wrap) : position;
}

template <typename Real>
Real Trajectories<Real>::spin_at(std::uint32_t ball, const Real& time) const {
    const SpinTrajectory<Real>& turn = spins_[ball];
    if (turn.rate == Real{}) return turn.spin;
    const Real since = time - turn.time;
    if (scene_.world->model().cloth)
        return cloth_spin_after(*scene_.world->model().cloth, turn.spin, since);
    return turn.spin + turn.rate * since;
}

template <typename Real>
void Trajectories<Real>::continue_spin(std::uint32_t ball, const Real& time) {
    spins_[ball] = {time, spin_at(ball, time), Real{}, false};
}

template <typename Real>
Vector<Real> Trajectories<Real>::roll_at(std::uint32_t ball, const Real& time) const {
    const Trajectory<Real> trajectory = balls_.trajectory(ball);
    const Real since = time - trajectory.time;
    if (trajectory.motion == Motion::slipping)
        return trajectory.center -
               trajectory.acceleration * (since / Real(*scene_.world->model().spin));
    if (trajectory.motion == Motion::rolling)
        return trajectory.velocity + trajectory.acceleration * since;
    return {};
}

template class Trajectories<double>;
template class Trajectories<DoubleDouble>;

}  // namespace carom
