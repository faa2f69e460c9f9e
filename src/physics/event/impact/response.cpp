#include "physics/event/impact/response.h"

#include <algorithm>
#include <array>

#include "physics/event/impact/squeeze.h"
#include "physics/event/motion/tolerances.h"
#include "physics/laws/contact_material.h"
#include "physics/laws/curve.h"

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
      scatter_counts_(parts.scatter_counts),
      restitution_(parts.scene, parts.balls, parts.cluster),
      lasting_(parts.scene, parts.cluster, restitution_),
      friction_(parts.scene, parts.cluster, parts.friction),
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
    correction_.apply(lost_);
    start_trajectories(record.touched);
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
    lost_ = Real{};
    for (std::size_t round = 0;; ++round) {
        find_approaching(round == 0);
        if (approaching_.empty()) break;
        if (round > 0) work_.count_rounds(1 + approaching_.size() * approaching_.size());
        const std::size_t points = cluster_.contacts().size();
        if (round > most_impact_rounds + impact_rounds_per_contact * points) break;
        if (round > most_impact_rounds / 2 + impact_rounds_per_contact / 2 * points) {
            if (!is_jammed) hold_frozen();
            is_jammed = true;
            stop_all();
        } else {
            pass_impulses(round == 0 && approaching_.size() == 1, contacts);
        }
        cluster_.note_speeds(is_jammed);
        const std::size_t count = cluster_.bodies().size();
        for (std::uint32_t i = 0; i < count; ++i)
            if (cluster_.bodies()[i].is_changed) cluster_.scan(i);
    }
    return is_jammed;
}

template <typename Real>
void Response<Real>::find_approaching(bool is_first_round) {
    approaching_.clear();
    const std::vector<ContactPoint<Real>>& points = cluster_.contacts();
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const ContactPoint<Real>& point = points[i];
        if (point.is_apart || !(cluster_.compliance(point) > Real{})) continue;
        const Real least = least_approach_of(point, is_first_round && i == 0);
        if (approach_of<Real>(point.contact, cluster_.motion()) > least) approaching_.push_back(i);
    }
}

// Slower approaches are rounding or, but for the contact of the event, rest.
template <typename Real>
Real Response<Real>::least_approach_of(const ContactPoint<Real>& point, bool is_of_event) const {
    const std::vector<ClusterBody<Real>>& bodies = cluster_.bodies();
    Real speeds = bodies[point.contact.a].fastest + absolute(point.contact.surface);
    if (point.contact.b != ImpactContact<Real>::fixed) speeds += bodies[point.contact.b].fastest;
    Real rounding = Real(residual_rounding<Real>) * speeds;
    if (scene_.field.pressing > Real{})
        rounding += Real(pressed_residual * pressed_rounding) *
                    square_root(scene_.field.pressing * cluster_.smaller_radius(point));
    return std::max(rounding, is_of_event ? Real{} : pressing_speed(point));
}

// The approach speed below which a contact point does not take part: bodies that gravity may press
// together would otherwise be separated again and again by slow approaches.
template <typename Real>
Real Response<Real>::pressing_speed(const ContactPoint<Real>& point) const {
    if (!scene_.world->model().gravity || !scene_.world->model().inelastic) return Real{};
    double height = rest_height;
    if (point.kind == EventKind::ball_ball && !cluster_.bodies()[point.contact.a].was_resting &&
        !cluster_.bodies()[point.contact.b].was_resting)
        height = moving_rest_height;
    return square_root(Real(2.0 * height) * length(scene_.field.gravity) *
                       cluster_.smaller_radius(point));
}

// The approaching contact points with their restitution, as a group for the simultaneous impact.
template <typename Real>
void Response<Real>::prepare_group(bool is_alone) {
    const World& world = *scene_.world;
    group_.clear();
    approach_.clear();
    rolls_on_ = false;
    for (const std::uint32_t index : approaching_) {
        ContactPoint<Real>& point = cluster_.contacts()[index];
        const double restitution = restitution_.of(point, is_alone);
        point.contact.restitution = Real(restitution);
        group_.push_back(point.contact);
        if (is_alone && world.model().curved) rolls_on_ = follow_curve(point);
        if (!rolls_on_ && point.kind == EventKind::ball_edge && world.model().scatter && is_alone &&
            point.contact.restitution > Real{}) {
            const std::uint32_t ball = cluster_.bodies()[point.contact.a].ball;
            const Vec2 velocity(cluster_.motion()[point.contact.a].velocity);
            group_.back().normal =
                Vector<Real>(bounce_normal(world, ball, scatter_counts_[ball],
                                           Vec2(group_.back().normal), velocity, restitution));
        }
        approach_.push_back(approach_of<Real>(group_.back(), cluster_.motion()));
    }
}

// A single ball meets an edge: gives the last contact of the group the normal of the curve of which
// the edge is a piece. Returns whether the ball rolls on.
template <typename Real>
bool Response<Real>::follow_curve(const ContactPoint<Real>& point) {
    if (point.kind != EventKind::ball_edge) return false;
    const ClusterBody<Real>& body = cluster_.bodies()[point.contact.a];
    const Vector<Real>& velocity = cluster_.motion()[point.contact.a].velocity;
    ImpactContact<Real>& contact = group_.back();
    const double reach = static_cast<double>(balls_.radius(body.ball)) +
                         scene_.world->capsules().shape[point.other].radius;
    const CurveBounce bounce =
        curve_bounce(*scene_.world, point.other,
                     {.position = Vec2(body.position),
                      .velocity = Vec2(velocity),
                      .normal = Vec2(contact.normal),
                      .reach = reach,
                      .restitution = static_cast<double>(contact.restitution)});
    if (bounce.way == CurveBounce::Way::bounces) contact.normal = Vector<Real>(bounce.normal);
    if (bounce.way != CurveBounce::Way::rolls_on) return false;
    contact.normal = rolling_normal(velocity, contact.normal);
    contact.restitution = Real(1.0);
    cluster_.bodies()[point.contact.a].rolls_on = true;
    return true;
}

// Replaces the approaching contact points by those of an impact that lasts, with its impulses.
// Returns false if the impact does not last.
template <typename Real>
bool Response<Real>::press_group() {
    const bool lasts = lasting_.press(approaching_);
    work_.count_rounds(lasting_.work());
    if (!lasts) return false;
    rolls_on_ = false;
    approaching_.clear();
    group_.clear();
    approach_.clear();
    passed_.clear();
    for (const HertzTouch<Real>& touch : lasting_.touches()) {
        approaching_.push_back(lasting_.point_of(touch));
        group_.push_back(cluster_.contacts()[approaching_.back()].contact);
        approach_.push_back(touch.approach);
        passed_.push_back(touch.impulse);
    }
    return true;
}

// One round's impulses. A resting ball does not wake if another comes to rest on it: it counts as
// immovable.
template <typename Real>
void Response<Real>::pass_impulses(bool is_alone, std::vector<Contact>& contacts) {
    const bool lasts = scene_.world->model().modulus && press_group();
    if (!lasts) prepare_group(is_alone);
    std::vector<ClusterBody<Real>>& bodies = cluster_.bodies();
    std::vector<ImpactBody<Real>>& motion = cluster_.motion();
    const bool is_soft = is_alone && !lasts &&
                         cluster_.contacts()[approaching_[0]].kind == EventKind::ball_ball &&
                         group_[0].restitution == Real{} && scene_.world->model().gravity;
    std::array<Real, 2> masses{};
    if (is_soft) {
        masses = {motion[group_[0].a].inverse_mass, motion[group_[0].b].inverse_mass};
        const bool both = bodies[group_[0].a].was_resting && bodies[group_[0].b].was_resting;
        for (const std::uint32_t body : {group_[0].a, group_[0].b})
            if (bodies[body].was_resting && !both) motion[body].inverse_mass = Real{};
    }
    if (lasts)
        for (std::size_t at = 0; at < group_.size(); ++at)
            push<Real>(motion, group_[at], passed_[at]);
    else if (group_.size() == 1)
        passed_.assign(1, reflect_alone<Real>(motion, group_[0]));
    else
        passed_ = reflect<Real>(motion, group_, &memory_);
    if (correction_.is_paid()) note_loss();
    if (scene_.world->model().spin) friction_.apply(approaching_, passed_);
    if (is_soft) {
        motion[group_[0].a].inverse_mass = masses[0];
        motion[group_[0].b].inverse_mass = masses[1];
    }
    for (std::size_t at = 0; at < approaching_.size(); ++at) {
        if (!(passed_[at] > Real{})) continue;
        const ContactPoint<Real>& point = cluster_.contacts()[approaching_[at]];
        for (const std::uint32_t body : {point.contact.a, point.contact.b})
            if (body != ImpactContact<Real>::fixed && !(is_soft && bodies[body].was_resting)) {
                bodies[body].is_changed = true;
                bodies[body].has_collided = bodies[body].has_collided || !rolls_on_;
            }
        record_contact(at, contacts);
    }
}

// The work of the normal impulses of a round, relative to the surfaces.
template <typename Real>
void Response<Real>::note_loss() {
    for (std::size_t at = 0; at < group_.size(); ++at)
        lost_ += Real(0.5) * passed_[at] *
                 (approach_[at] + approach_of<Real>(group_[at], cluster_.motion()));
}

// Applies the kick of an edge after a contact of the group has passed its impulse, and records it.
template <typename Real>
void Response<Real>::record_contact(std::size_t at, std::vector<Contact>& contacts) {
    const World& world = *scene_.world;
    const ContactPoint<Real>& point = cluster_.contacts()[approaching_[at]];
    const ClusterBody<Real>& body = cluster_.bodies()[point.contact.a];
    const bool on_ball = point.kind == EventKind::ball_ball;
    const bool is_swapped = on_ball && point.other < body.ball;
    const Vec2 place(body.position - point.contact.normal * balls_.radius(body.ball));
    const Vec2 normal(group_[at].normal);
    const double approach = static_cast<double>(approach_[at]);
    if (world.model().kicks && !on_ball)
        cluster_.motion()[point.contact.a].velocity +=
            group_[at].normal *
            Real(kick_of_edge(world, point.other, world.capsules().shape[point.other], place,
                              approach));
    contacts.push_back({.time = static_cast<double>(scene_.now),
                        .kind = on_ball ? ContactKind::ball_ball : ContactKind::ball_edge,
                        .a = is_swapped ? point.other : body.ball,
                        .b = is_swapped ? body.ball : point.other,
                        .point = place,
                        .normal = is_swapped ? -normal : normal,
                        .approach = approach,
                        .impulse = static_cast<double>(passed_[at])});
}

// All contact points that can give way pass impulses without restitution, at once.
template <typename Real>
void Response<Real>::stop_all() {
    group_.clear();
    for (const ContactPoint<Real>& point : cluster_.contacts()) {
        if (point.is_apart || !(cluster_.compliance(point) > Real{})) continue;
        group_.push_back(point.contact);
        group_.back().restitution = Real{};
    }
    reflect<Real>(cluster_.motion(), group_, &memory_);
    for (ClusterBody<Real>& each : cluster_.bodies())
        each.is_changed = true;
}

// A frozen ball stops the jammed balls that hit it. If it moved instead, it would be frozen again
// at once, and they would hit it again.
template <typename Real>
void Response<Real>::hold_frozen() {
    for (std::size_t i = 0; i < cluster_.bodies().size(); ++i)
        if (guard_.is_frozen(balls_.trajectory(cluster_.bodies()[i].ball)))
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

template class Response<double>;
template class Response<DoubleDouble>;

}  // namespace carom
