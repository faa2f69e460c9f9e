#include "physics/event/standstill.h"

namespace carom {

template <typename Real>
void Standstill<Real>::stop(std::uint32_t ball) {
    const Model& model = scene_.world->model();
    const BallState<Real> state = trajectories_.state_now(ball);
    const std::uint32_t collisions = balls_[ball].line.recent_collisions;
    standing_.push_back(ball);
    motions_.push_back({.velocity = state.velocity});
    if (model.cloth) motions_.back().roll = trajectories_.roll_at(ball, scene_.now);
    if (model.spin) motions_.back().spin = trajectories_.spin_at(ball, scene_.now);
    balls_.plan(ball).inverse_mass = Real{};
    trajectories_.start(ball, scene_.now, state.position, {});
    trajectories_.hold(ball);
    balls_[ball].line.recent_collisions = collisions;
    if (model.spin) trajectories_.spin(ball) = {scene_.now, Real{}, Real{}, false};
    trajectories_.set_all_straight(false);
}

template <typename Real>
void Standstill<Real>::end_tick() {
    const Model& model = scene_.world->model();
    for (std::size_t at = 0; at < standing_.size(); ++at) {
        const std::uint32_t ball = standing_[at];
        const Motions& motions = motions_[at];
        const std::uint32_t collisions = balls_[ball].line.recent_collisions;
        trajectories_.start(ball, scene_.now, trajectories_.state_now(ball).position,
                            motions.velocity);
        balls_[ball].line.recent_collisions = collisions;
        if (model.spin) trajectories_.spin(ball) = {scene_.now, motions.spin, Real{}, false};
        if (!model.cloth) continue;
        balls_.curve(ball).center = motions.roll;
        cloth_.begin_phase(ball);
    }
}

template class Standstill<double>;
template class Standstill<DoubleDouble>;

}  // namespace carom
