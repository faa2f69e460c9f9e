#include "physics/event/motion/kinematic_bodies.h"

#include "physics/tick/kinematic.h"

namespace carom {

template <typename Real>
void KinematicBodies<Real>::take() {
    const World& world = *scene_.world;
    const Real duration = scene_.end - scene_.now;
    for (const HeldBall& held : world.held_balls()) {
        const auto index = index_of(world, held.id);
        if (!index) continue;
        const Vec2 displacement =
            displacement_to_target(world, held, world.balls().position[*index]);
        balls_.plan(*index).inverse_mass = Real{};
        balls_[*index].line.velocity = Vector<Real>(displacement) / duration;
    }
    edges_.clear();
    list_kinematic_edges(world, held_);
    for (const HeldEdge& listed : held_) {
        const HeldCapsule& held = world.held_capsules()[listed.held];
        const Capsule& shape = world.capsules().shape[listed.capsule];
        KinematicEdge<Real> edge;
        edge.capsule = listed.capsule;
        edge.is_motorised = listed.is_driven;
        edge.edge.edge = Edge<Real>(shape, {});
        edge.edge.start_velocity = Vector<Real>(held.start_target - shape.start) / duration;
        edge.edge.end_velocity = Vector<Real>(held.end_target - shape.end) / duration;
        edge.edge.time = scene_.now;
        edge.edge.stop = scene_.end;
        edges_.push_back(edge);
    }
}

template <typename Real>
bool KinematicBodies<Real>::stop() {
    bool has_moved = false;
    for (KinematicEdge<Real>& edge : edges_) {
        if (edge.is_stopped) continue;
        edge.is_stopped = true;
        edge.edge.stop = scene_.now;
        has_moved = true;
    }
    for (std::uint32_t i = 0; i < balls_.size(); ++i) {
        const LinearPart<Real>& line = balls_[i].line;
        if (line.motion != Motion::held || line.velocity == Vector<Real>{}) continue;
        trajectories_.start(i, scene_.now, trajectories_.state_now(i).position, {});
        trajectories_.hold(i);
        has_moved = true;
    }
    has_stopped_ = has_stopped_ || has_moved;
    return has_moved;
}

template class KinematicBodies<double>;
template class KinematicBodies<DoubleDouble>;

}  // namespace carom
