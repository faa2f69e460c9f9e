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
        const auto periods = [](double way, double period) {
            return static_cast<int>(way / period + (way < 0.0 ? -0.5 : 0.5));
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
void Trajectories<Real>::put_to_rest(std::uint32_t ball, const PathSupport& support,
                                     const PathSupport& second_support) {
    Trajectory<Real> path = balls_.path(ball);
    path.motion = Motion::resting;
    path.velocity = path.acceleration = {};
    path.support = support;
    path.second_support = second_support;
    balls_.set_path(ball, path);
}

template <typename Real>
Vec2 Trajectories<Real>::shown_position(const Trajectory<Real>& path, const Real& time) const {
    const Vec2 position(state_at(path, scene_.field, time).position);
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
    const Trajectory<Real> path = balls_.path(ball);
    const Real since = time - path.time;
    if (path.motion == Motion::slipping)
        return path.center - path.acceleration * (since / Real(*scene_.world->model().spin));
    if (path.motion == Motion::rolling) return path.velocity + path.acceleration * since;
    return {};
}

template class Trajectories<double>;
template class Trajectories<DoubleDouble>;

}  // namespace carom
