#include "physics/event/impact/impact_group.h"

#include <algorithm>

#include "physics/event/motion/tolerances.h"
#include "physics/laws/contact_material.h"
#include "physics/laws/curve.h"

namespace carom {

template <typename Real>
ImpactGroup<Real>::ImpactGroup(const Parts& parts)
    : scene_(parts.scene),
      balls_(parts.balls),
      cluster_(parts.cluster),
      work_(parts.work),
      scatter_counts_(parts.scatter_counts),
      restitution_(parts.scene, parts.balls, parts.kinematic, parts.cluster),
      lasting_(parts.scene, parts.cluster, restitution_),
      friction_(parts.scene, parts.cluster, parts.friction) {}

template <typename Real>
void ImpactGroup<Real>::begin(bool counts_loss) {
    counts_loss_ = counts_loss;
    lost_ = Real{};
}

template <typename Real>
std::size_t ImpactGroup<Real>::find(bool is_first_round) {
    approaching_.clear();
    const std::vector<ContactPoint<Real>>& points = cluster_.contacts();
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const ContactPoint<Real>& point = points[i];
        if (point.is_apart || !(cluster_.compliance(point) > Real{})) continue;
        const Real least = least_approach_of(point, is_first_round && i == 0);
        if (approach_of<Real>(point.contact, cluster_.motion()) > least) approaching_.push_back(i);
    }
    if (scene_.world->model().hinged) add_stops();
    return approaching_.size();
}

// Slower approaches are rounding or, but for the contact of the event, rest.
template <typename Real>
Real ImpactGroup<Real>::least_approach_of(const ContactPoint<Real>& point, bool is_of_event) const {
    const std::vector<ClusterBody<Real>>& bodies = cluster_.bodies();
    if (point.is_stop || point.contact.is_hinged) return least_turn_of(point);
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
Real ImpactGroup<Real>::pressing_speed(const ContactPoint<Real>& point) const {
    if (!(scene_.field.pressing > Real{})) return Real{};
    double height = rest_height;
    if (point.kind == EventKind::ball_ball && !cluster_.bodies()[point.contact.a].was_resting &&
        !cluster_.bodies()[point.contact.b].was_resting)
        height = moving_rest_height;
    return square_root(Real(2.0 * height) * length(scene_.field.gravity) *
                       cluster_.smaller_radius(point));
}

// The approaching contact points with their restitution, as a group for the simultaneous impact.
template <typename Real>
void ImpactGroup<Real>::prepare(bool is_alone) {
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
bool ImpactGroup<Real>::follow_curve(const ContactPoint<Real>& point) {
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
bool ImpactGroup<Real>::press() {
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

// The impact of two balls of which the one may come to rest on the other.
template <typename Real>
bool ImpactGroup<Real>::is_soft() const {
    return cluster_.contacts()[approaching_[0]].kind == EventKind::ball_ball &&
           group_[0].restitution == Real{} && scene_.world->model().gravity;
}

// If one of the two bodies of the group was resting, it counts as immovable from now on. Returns
// their masses.
template <typename Real>
typename ImpactGroup<Real>::Masses ImpactGroup<Real>::hold_resting() {
    const std::vector<ClusterBody<Real>>& bodies = cluster_.bodies();
    std::vector<ImpactBody<Real>>& motion = cluster_.motion();
    const Masses masses{motion[group_[0].a].inverse_mass, motion[group_[0].b].inverse_mass};
    const bool both = bodies[group_[0].a].was_resting && bodies[group_[0].b].was_resting;
    for (const std::uint32_t body : {group_[0].a, group_[0].b})
        if (bodies[body].was_resting && !both) motion[body].inverse_mass = Real{};
    return masses;
}

template <typename Real>
void ImpactGroup<Real>::pass_impulses(bool is_first_round, std::vector<Contact>& contacts) {
    const bool is_alone = is_first_round && count_without_stops() == 1;
    const bool lasts = scene_.world->model().modulus && press();
    if (!lasts) prepare(is_alone);
    std::vector<ImpactBody<Real>>& motion = cluster_.motion();
    const bool is_soft_impact = is_alone && !lasts && is_soft();
    Masses masses;
    if (is_soft_impact) masses = hold_resting();
    if (lasts)
        for (std::size_t at = 0; at < group_.size(); ++at)
            push<Real>(motion, group_[at], passed_[at]);
    else if (group_.size() == 1)
        passed_.assign(1, reflect_alone<Real>(motion, group_[0]));
    else
        passed_ = reflect<Real>(motion, group_, &memory_);
    if (counts_loss_) note_loss();
    if (scene_.world->model().spin) friction_.apply(approaching_, passed_);
    if (is_soft_impact) {
        motion[group_[0].a].inverse_mass = masses.a;
        motion[group_[0].b].inverse_mass = masses.b;
    }
    note_changes(is_soft_impact, contacts);
}

// Marks the bodies that an impulse has changed, and records the contacts. In a soft impact a
// resting ball does not change.
template <typename Real>
void ImpactGroup<Real>::note_changes(bool is_soft, std::vector<Contact>& contacts) {
    std::vector<ClusterBody<Real>>& bodies = cluster_.bodies();
    for (std::size_t at = 0; at < approaching_.size(); ++at) {
        if (!(passed_[at] > Real{})) continue;
        const ContactPoint<Real>& point = cluster_.contacts()[approaching_[at]];
        for (const std::uint32_t body : {point.contact.a, point.contact.b})
            if (body != ImpactContact<Real>::fixed && !(is_soft && bodies[body].was_resting)) {
                bodies[body].is_changed = true;
                bodies[body].has_collided = bodies[body].has_collided || !rolls_on_;
            }
        if (point.is_stop)
            hold_at_stop(at);
        else
            record_contact(at, contacts);
    }
}

// The work of the normal impulses of a round, relative to the surfaces.
template <typename Real>
void ImpactGroup<Real>::note_loss() {
    for (std::size_t at = 0; at < group_.size(); ++at)
        lost_ += Real(0.5) * passed_[at] *
                 (approach_[at] + approach_of<Real>(group_[at], cluster_.motion()));
}

// Applies the kick of an edge after a contact of the group has passed its impulse, and records it.
template <typename Real>
void ImpactGroup<Real>::record_contact(std::size_t at, std::vector<Contact>& contacts) {
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
void ImpactGroup<Real>::stop_all() {
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

template class ImpactGroup<double>;
template class ImpactGroup<DoubleDouble>;

}  // namespace carom
