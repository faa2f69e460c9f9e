#include "physics/event/rest/cloth_phases.h"

namespace carom {

template <typename Real>
ClothPhase<Real> ClothPhases<Real>::phase_of(const Trajectory<Real>& trajectory) const {
    return cloth_phase(*scene_.world->model().cloth, *scene_.world->model().spin,
                       trajectory.velocity, trajectory.center);
}

template <typename Real>
void ClothPhases<Real>::begin_phase(std::uint32_t ball) {
    constexpr int most_edges = 4;
    Trajectory<Real> trajectory = balls_.trajectory(ball);
    ClothPhase<Real> phase = phase_of(trajectory);
    for (int i = 0; phase.motion == ClothMotion::sliding; ++i) {
        const auto edge = supports_.barrier_to(ball, trajectory.velocity, phase.acceleration);
        if (!edge) break;
        trajectory.velocity -= edge->normal * dot(trajectory.velocity, edge->normal);
        trajectory.center -= edge->normal * dot(trajectory.center, edge->normal);
        if (i == most_edges) trajectory.center = trajectory.velocity;
        phase = phase_of(trajectory);
    }
    // A phase too short for the clock to resolve ends at once.
    while (phase.lasts && trajectory.time + *phase.lasts == trajectory.time) {
        const bool stops = phase.motion == ClothMotion::rolling;
        trajectory.velocity =
            stops ? Vector<Real>{} : trajectory.velocity + phase.acceleration * *phase.lasts;
        trajectory.center = trajectory.velocity;
        phase = phase_of(trajectory);
    }
    trajectory.acceleration = phase.acceleration;
    switch (phase.motion) {
        case ClothMotion::sliding:
            trajectory.motion = Motion::slipping;
            break;
        case ClothMotion::rolling:
            trajectory.motion = Motion::rolling;
            trajectory.center = trajectory.velocity;
            break;
        case ClothMotion::still:
            trajectory.motion = Motion::still;
            trajectory.velocity = trajectory.center = {};
    }
    balls_.set_trajectory(ball, trajectory);
    SpinTrajectory<Real>& turn = trajectories_.spin(ball);
    const Real rate(scene_.world->model().cloth->spin);
    turn.rate = turn.spin == Real{} ? Real{} : (turn.spin < Real{} ? rate : -rate);
}

template <typename Real>
std::optional<Real> ClothPhases<Real>::end_of_phase(std::uint32_t ball) const {
    const Trajectory<Real> trajectory = balls_.trajectory(ball);
    const ClothPhase<Real> phase = phase_of(trajectory);
    if (!phase.lasts) return std::nullopt;
    return trajectory.time + *phase.lasts;
}

template <typename Real>
void ClothPhases<Real>::end_phase(std::uint32_t ball) {
    const Trajectory<Real> before = balls_.trajectory(ball);
    const BallState<Real> state = trajectories_.state_now(ball);
    const bool stops = before.motion == Motion::rolling;
    trajectories_.start(ball, scene_.now, state.position, stops ? Vector<Real>{} : state.velocity);
    balls_.curve(ball).center = balls_[ball].line.velocity;
    balls_[ball].line.recent_collisions = before.recent_collisions;
    begin_phase(ball);
}

template <typename Real>
bool ClothPhases<Real>::is_of_this_cloth(const Trajectory<Real>& trajectory) const {
    if (!scene_.world->model().cloth) return !is_on_cloth(trajectory);
    return is_on_cloth(trajectory) && phase_of(trajectory).acceleration == trajectory.acceleration;
}

template class ClothPhases<double>;
template class ClothPhases<DoubleDouble>;

}  // namespace carom
