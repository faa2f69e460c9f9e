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
    if (!world.seesaws().empty() || !seesaws_.empty()) seesaws_ = world.seesaws();
    list_kinematic_edges(world, held_);
    for (const HeldEdge& listed : held_) {
        const HeldCapsule& held = world.held_capsules()[listed.held];
        const Capsule& shape = world.capsules().shape[listed.capsule];
        KinematicEdge<Real> edge;
        edge.capsule = listed.capsule;
        edge.is_driven = listed.is_driven;
        edge.edge.edge = Edge<Real>(shape, {});
        edge.edge.start_velocity = Vector<Real>(held.start_target - shape.start) / duration;
        edge.edge.end_velocity = Vector<Real>(held.end_target - shape.end) / duration;
        edge.edge.time = scene_.now;
        edge.edge.stop = scene_.end;
        if (held.is_seesaw) {
            edge.seesaw = *carom::seesaw_of(world, held.id);
            set_motion(edge, seesaws_[edge.seesaw]);
        }
        edges_.push_back(edge);
    }
    find_next_stop();
}

template <typename Real>
void KinematicBodies<Real>::set_motion(KinematicEdge<Real>& edge, const Seesaw& seesaw) {
    seesaws_[edge.seesaw] = seesaw;
    edge.edge.edge = Edge<Real>(seesaw_shape(seesaw, seesaw.angle), {});
    edge.is_standing = is_standing(seesaw);
    edge.is_stopped = edge.is_standing;
    edge.edge.is_hinged = !edge.is_standing;
    edge.edge.pivot = Vector<Real>(seesaw.pivot);
    edge.edge.rate = Real(seesaw.rate);
    edge.edge.time = scene_.now;
    if (edge.is_standing) edge.edge.stop = scene_.now;
}

template <typename Real>
Seesaw KinematicBodies<Real>::seesaw_at(const KinematicEdge<Real>& edge, const Real& when) const {
    Seesaw seesaw = seesaw_of(edge);
    turn_on(seesaw, static_cast<double>(when - edge.edge.time));
    return seesaw;
}

template <typename Real>
void KinematicBodies<Real>::turn(std::uint32_t index, double rate) {
    KinematicEdge<Real>& edge = edges_[index];
    Seesaw seesaw = seesaw_at(edge, scene_.now);
    seesaw.rate = rate;
    set_motion(edge, seesaw);
    find_next_stop();
    has_stopped_ = true;
}

template <typename Real>
void KinematicBodies<Real>::find_next_stop() {
    next_stop_ = Real(std::numeric_limits<double>::infinity());
    for (const KinematicEdge<Real>& edge : edges_) {
        if (!edge.is_seesaw()) continue;
        const Real stop = edge.edge.time + Real(time_to_stop(seesaw_of(edge)));
        if (stop < next_stop_) next_stop_ = stop;
    }
}

template <typename Real>
void KinematicBodies<Real>::bounce_at_stops() {
    for (KinematicEdge<Real>& edge : edges_) {
        if (!edge.is_seesaw()) continue;
        if (scene_.now < edge.edge.time + Real(time_to_stop(seesaw_of(edge)))) continue;
        Seesaw seesaw = seesaw_of(edge);
        bounce_at_stop(seesaw);
        set_motion(edge, seesaw);
    }
    find_next_stop();
    has_stopped_ = true;
}

template <typename Real>
bool KinematicBodies<Real>::stop() {
    bool has_moved = false;
    for (KinematicEdge<Real>& edge : edges_) {
        if (edge.is_stopped || edge.is_seesaw()) continue;
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
