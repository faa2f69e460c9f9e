#include "physics/event/impact/response.h"

#include <algorithm>

#include "physics/event/impact/squeeze.h"
#include "physics/event/motion/tolerances.h"

namespace carom {

template <typename Real>
Response<Real>::Response(const Parts& parts)
    : scene_(parts.scene),
      balls_(parts.balls),
      space_(parts.space),
      trajectories_(parts.trajectories),
      kinematic_(parts.kinematic),
      cluster_(parts.cluster),
      rest_(parts.rest),
      guard_(parts.guard),
      work_(parts.work),
      group_({parts.scene, parts.balls, parts.kinematic, parts.cluster, parts.friction, parts.work,
              parts.scatter_counts}),
      correction_(parts.scene, parts.balls, parts.space, parts.cluster) {}

template <typename Real>
const std::vector<std::uint32_t>& Response<Real>::resolve(std::uint32_t ball,
                                                          const BallEvent<Real>& event,
                                                          const ImpactRecord& record) {
    const std::size_t contacts = record.contacts.size();
    cluster_.begin(ball, event);
    bool is_jammed = run_rounds(record.contacts);
    const bool can_hold_back = hold_back(cluster_, balls_);
    if ((!can_hold_back || pushes_without_end(cluster_, balls_, is_jammed)) && kinematic_.stop()) {
        // The kinematic bodies stop before this impact, so it is computed again without their push.
        record.contacts.resize(contacts);
        cluster_.end();
        cluster_.begin(ball, event);
        is_jammed = run_rounds(record.contacts);
    }
    correction_.apply(group_.lost());
    start_trajectories(record.touched);
    note_sunk();
    for (const std::uint32_t each : changed_)
        rest_.settle(each);
    for (const std::uint32_t each : changed_)
        guard_.freeze_if_due(each, is_jammed);
    return changed_;
}

// Applies impulses until nothing approaches. Returns whether the balls are jammed.
template <typename Real>
bool Response<Real>::run_rounds(std::vector<Contact>& contacts) {
    bool is_jammed = false;
    group_.begin(correction_.is_paid());
    for (std::size_t round = 0;; ++round) {
        const std::size_t approaching = group_.find(round == 0);
        if (approaching == 0) break;
        if (round > 0) work_.count_rounds(1 + approaching * approaching);
        const std::size_t points = cluster_.contacts().size();
        if (round > most_impact_rounds + impact_rounds_per_contact * points) break;
        if (round > most_impact_rounds / 2 + impact_rounds_per_contact / 2 * points) {
            if (!is_jammed) hold_frozen();
            is_jammed = true;
            group_.stop_all();
        } else {
            group_.pass_impulses(round == 0, contacts);
        }
        cluster_.note_speeds(is_jammed);
        const std::size_t count = cluster_.bodies().size();
        for (std::uint32_t i = 0; i < count; ++i)
            if (cluster_.bodies()[i].is_changed) cluster_.scan(i);
    }
    return is_jammed;
}

// A frozen ball stops the jammed balls that hit it. If it moved instead, it would be frozen again
// at once, and they would hit it again.
template <typename Real>
void Response<Real>::hold_frozen() {
    for (std::size_t i = 0; i < cluster_.bodies().size(); ++i)
        if (cluster_.bodies()[i].is_ball() &&
            guard_.is_frozen(balls_.trajectory(cluster_.bodies()[i].ball)))
            cluster_.motion()[i] = {{}, Real{}};
}

// Starts the new trajectory of every changed body, and free flight of what it supported.
template <typename Real>
void Response<Real>::start_trajectories(std::vector<std::uint8_t>& touched) {
    const Model& model = scene_.world->model();
    const std::vector<ClusterBody<Real>>& bodies = cluster_.bodies();
    changed_.clear();
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        const ClusterBody<Real>& each = bodies[i];
        if (!each.is_ball()) {
            if (each.is_changed)
                kinematic_.turn(each.seesaw, static_cast<double>(cluster_.motion()[i].velocity.x));
            continue;
        }
        touched[each.ball] |= each.is_changed;
        if (!each.is_changed) continue;
        const Trajectory<Real> before = balls_.trajectory(each.ball);
        if (each.is_moved) space_.cells().leave(balls_, each.ball);
        trajectories_.start(each.ball, scene_.now, each.position, cluster_.motion()[i].velocity);
        LinearPart<Real>& line = balls_[each.ball].line;
        if (each.is_moved) space_.cells().enter(balls_, each.ball, Vec2(line.position));
        if (model.spin) trajectories_.spin(each.ball).spin = each.spin;
        if (model.cloth) balls_.curve(each.ball).center = each.roll;
        line.recent_collisions = each.rolls_on && !each.has_collided
                                     ? before.recent_collisions
                                     : guard_.count(each.ball, before, each.position);
        if (before.motion == Motion::held) trajectories_.hold(each.ball);
        if (line.recent_collisions > dense_collisions && cluster_.touches_ball(i))
            guard_.note_dense(each.ball);
        changed_.push_back(each.ball);
    }
    for (const ClusterBody<Real>& each : bodies)
        if (each.is_changed && each.was_resting) rest_.release_supported(each.ball, changed_);
    std::sort(changed_.begin(), changed_.end());
    changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
}

// Pairs that sink in deeper than position correction has opened them.
template <typename Real>
void Response<Real>::note_sunk() {
    const std::vector<ClusterBody<Real>>& bodies = cluster_.bodies();
    for (const ContactPoint<Real>& point : cluster_.contacts()) {
        const Real most = Real(most_sunk) * cluster_.smaller_radius(point);
        if (point.kind != EventKind::ball_ball || !(point.gap < -most)) continue;
        const ClusterBody<Real>& a = bodies[point.contact.a];
        const ClusterBody<Real>& b = bodies[point.contact.b];
        guard_.note_sunk(a.ball);
        guard_.note_sunk(b.ball);
    }
}

template class Response<double>;
template class Response<DoubleDouble>;

}  // namespace carom
