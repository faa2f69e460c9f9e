#include "physics/event/rest/cloth_phases.h"

namespace carom {

template <typename Real>
ClothPhase<Real> ClothPhases<Real>::phase_of(const Trajectory<Real>& path) const {
    return cloth_phase(*scene_.world->model().cloth, *scene_.world->model().spin, path.velocity,
                       path.center);
}

template <typename Real>
void ClothPhases<Real>::begin_phase(std::uint32_t ball) {
    constexpr int most_edges = 4;
    Trajectory<Real> path = balls_.path(ball);
    ClothPhase<Real> phase = phase_of(path);
    for (int i = 0; phase.motion == ClothMotion::sliding; ++i) {
        const auto edge = supports_.barrier_to(ball, path.velocity, phase.acceleration);
        if (!edge) break;
        path.velocity -= edge->normal * dot(path.velocity, edge->normal);
        path.center -= edge->normal * dot(path.center, edge->normal);
        if (i == most_edges) path.center = path.velocity;
        phase = phase_of(path);
    }
    // A phase too short for the clock to resolve ends at once.
    while (phase.lasts && path.time + *phase.lasts == path.time) {
        const bool stops = phase.motion == ClothMotion::rolling;
        path.velocity = stops ? Vector<Real>{} : path.velocity + phase.acceleration * *phase.lasts;
        path.center = path.velocity;
        phase = phase_of(path);
    }
    path.acceleration = phase.acceleration;
    switch (phase.motion) {
        case ClothMotion::sliding:
            path.motion = Motion::slipping;
            break;
        case ClothMotion::rolling:
            path.motion = Motion::rolling;
            path.center = path.velocity;
            break;
        case ClothMotion::still:
            path.motion = Motion::still;
            path.velocity = path.center = {};
    }
    balls_.set_path(ball, path);
    SpinTrajectory<Real>& turn = trajectories_.spin(ball);
    const Real rate(scene_.world->model().cloth->spin);
    turn.rate = turn.spin == Real{} ? Real{} : (turn.spin < Real{} ? rate : -rate);
}

template <typename Real>
std::optional<Real> ClothPhases<Real>::end_of_phase(std::uint32_t ball) const {
    const Trajectory<Real> path = balls_.path(ball);
    const ClothPhase<Real> phase = phase_of(path);
    if (!phase.lasts) return std::nullopt;
    return path.time + *phase.lasts;
}

template <typename Real>
void ClothPhases<Real>::end_phase(std::uint32_t ball) {
    const Trajectory<Real> before = balls_.path(ball);
    const BallState<Real> state = trajectories_.state_now(ball);
    const bool stops = before.motion == Motion::rolling;
    trajectories_.start(ball, scene_.now, state.position, stops ? Vector<Real>{} : state.velocity);
    balls_.curve(ball).center = balls_[ball].line.velocity;
    balls_[ball].line.recent_collisions = before.recent_collisions;
    begin_phase(ball);
}

template <typename Real>
bool ClothPhases<Real>::is_of_this_cloth(const Trajectory<Real>& path) const {
    if (!scene_.world->model().cloth) return !is_on_cloth(path);
    return is_on_cloth(path) && phase_of(path).acceleration == path.acceleration;
}

template class ClothPhases<double>;
template class ClothPhases<DoubleDouble>;

}  // namespace carom
