#include "physics/event/impact/impact_cluster.h"

#include <algorithm>

#include "physics/event/motion/tolerances.h"
#include "physics/memory/branchless.h"

namespace carom {

template <typename Real>
void ImpactCluster<Real>::begin(std::uint32_t ball, const BallEvent<Real>& event) {
    bodies_.clear();
    motion_.clear();
    contacts_.clear();
    neighbour_count_ = 0;
    is_corrected_ = false;
    image_changes_ = trajectories_.image_changes();
    // Seen from the lower ball, whichever has the event: the other may not know of it yet.
    const bool is_pair = event.kind == EventKind::ball_ball;
    const bool is_swapped = is_pair && event.other < ball;
    const std::uint32_t body = add_body(select(is_swapped, event.other, ball));
    const int side = 1 - 2 * static_cast<int>(is_swapped);
    if (is_pair)
        add_ball(body, select(is_swapped, ball, event.other), side * event.across,
                 side * event.along, true);
    else if (event.kind == EventKind::kinematic_edge)
        add_kinematic_edge(body, kinematic_.edges()[event.other], true);
    else
        add_edge(body, event.other, event.across, event.along, true);
    const std::uint32_t other = contacts_.front().contact.b;
    bodies_[body].is_changed = true;
    if (other != ImpactContact<Real>::fixed && !bodies_[other].was_resting)
        bodies_[other].is_changed = true;
    scan(body);
    if (other != ImpactContact<Real>::fixed) scan(other);
}

template <typename Real>
void ImpactCluster<Real>::end() {
    for (const ClusterBody<Real>& each : bodies_)
        if (each.is_ball()) body_of_[each.ball] = BallRecord<Real>::none;
}

template <typename Real>
std::uint32_t ImpactCluster<Real>::add_body(std::uint32_t ball) {
    if (body_of_[ball] != BallRecord<Real>::none) return body_of_[ball];
    const auto body = static_cast<std::uint32_t>(bodies_.size());
    const BallState<Real> state = trajectories_.state_now(ball);
    bodies_.push_back({.ball = ball,
                       .position = state.position,
                       .fastest = length(state.velocity),
                       .was_resting = balls_[ball].line.motion == Motion::resting});
    motion_.push_back({state.velocity, balls_.plan(ball).inverse_mass});
    if (scene_.world->model().spin) bodies_.back().spin = trajectories_.spin_at(ball, scene_.now);
    if (scene_.world->model().cloth) bodies_.back().roll = trajectories_.roll_at(ball, scene_.now);
    body_of_[ball] = body;
    return body;
}

template <typename Real>
void ImpactCluster<Real>::add_ball(std::uint32_t body, std::uint32_t other, int across, int along,
                                   bool is_certain) {
    const std::uint32_t ball = bodies_[body].ball;
    const std::uint32_t known = body_of_[other];
    if (known != BallRecord<Real>::none && bodies_[known].is_scanned && !is_certain) return;
    const Vector<Real> shift = scene_.image_shift(across, along);
    const Vector<Real> theirs = known != BallRecord<Real>::none ? bodies_[known].position
                                                                : trajectories_.position_now(other);
    const Vector<Real> offset = bodies_[body].position - theirs - shift;
    const Real reach = balls_.radius(ball) + balls_.radius(other);
    const Real distance = length(offset);
    ContactPoint<Real> point;
    point.kind = EventKind::ball_ball;
    point.other = other;
    point.gap = distance - reach;
    point.contact.a = body;
    point.contact.b = add_body(other);
    point.contact.normal = distance > Real{}
                               ? offset / distance
                               : Vector<Real>{ball < other ? Real(1.0) : Real(-1.0), Real{}};
    point.support = {SupportId::Kind::ball, static_cast<std::int8_t>(across),
                     static_cast<std::int8_t>(along), number(scene_.world->balls().id[other])};
    contacts_.push_back(point);
}

template <typename Real>
Real ImpactCluster<Real>::slop_at(std::uint32_t body, const Real& size, const Real& reach) const {
    return size * Real(contact_slop) +
           Real(gap_roundings) * rounding_at(bodies_[body].position, reach);
}

template <typename Real>
void ImpactCluster<Real>::add_edge(std::uint32_t body, std::uint32_t capsule, int across, int along,
                                   bool is_certain) {
    const Vec2 shift{scene_.period.x * across, scene_.period.y * along};
    const Edge<Real> edge(scene_.world->capsules().shape[capsule], shift);
    const Real size = radius_of(body);
    const auto contact = contact_with(edge, bodies_[body].position, size);
    if (!is_certain && contact.gap > slop_at(body, size, size + edge.radius)) return;
    if (!is_certain && !scene_.is_solid(capsule, bodies_[body].position, shift)) return;
    ContactPoint<Real> point;
    point.kind = EventKind::ball_edge;
    point.other = capsule;
    point.gap = contact.gap;
    point.contact.a = body;
    point.contact.normal = contact.normal;
    point.support = {SupportId::Kind::edge, static_cast<std::int8_t>(across),
                     static_cast<std::int8_t>(along), number(scene_.world->capsules().id[capsule])};
    contacts_.push_back(point);
}

template <typename Real>
void ImpactCluster<Real>::add_kinematic_edge(std::uint32_t body, const KinematicEdge<Real>& edge,
                                             bool is_certain) {
    const Real size = radius_of(body);
    const auto contact = contact_with(edge.edge.at(scene_.now), bodies_[body].position, size);
    if (!is_certain && contact.gap > slop_at(body, size, size)) return;
    ContactPoint<Real> point;
    point.kind = EventKind::kinematic_edge;
    point.other = edge.capsule;
    point.is_driven = edge.is_driven;
    point.gap = contact.gap;
    point.contact.a = body;
    point.contact.normal = contact.normal;
    if (edge.is_seesaw()) return add_hinged(point, edge);
    if (!edge.is_stopped) {
        point.surface_velocity =
            edge.edge.start_velocity +
            (edge.edge.end_velocity - edge.edge.start_velocity) * contact.place;
        point.contact.surface = dot(contact.normal, point.surface_velocity);
    }
    contacts_.push_back(point);
}

template <typename Real>
bool ImpactCluster<Real>::may_touch(std::uint32_t body, const Neighbour<Real>& neighbour) const {
    const Real our_radius = radius_of(body);
    const Real their_radius = balls_.radius(neighbour.other);
    const Real small = our_radius < their_radius ? our_radius : their_radius;
    const Real limit = neighbour.reach + small * Real(contact_slop) +
                       Real(gap_roundings) * rounding_at(bodies_[body].position, neighbour.reach);
    return !(length_squared(neighbour.offset) > limit * limit);
}

// Notes all balls in the cells around the body's, and in close_ those that may touch it. The ball
// that the event is about is left out: its contact point exists.
template <typename Real>
void ImpactCluster<Real>::find_neighbours(std::uint32_t body) {
    const std::uint32_t ball = bodies_[body].ball;
    const Vector<Real> position = bodies_[body].position;
    const Real size = balls_.radius(ball);
    const BallRecord<Real>* const balls = balls_.data();
    const bool is_uniform = !scene_.world->model().gravity && !scene_.field.has_drag;
    const bool wraps = scene_.world->model().wrap.has_value();
    const ContactPoint<Real>& first = contacts_.front();
    const std::uint32_t first_ball = bodies_[first.contact.a].ball;
    const std::uint32_t second_ball =
        select(first.other == ball, first_ball, BallRecord<Real>::none);
    const std::uint32_t partner = first.kind != EventKind::ball_ball
                                      ? BallRecord<Real>::none
                                      : select(first.contact.a == body, first.other, second_ball);
    // Nearly all neighbours are further away than a rough limit, which no ball that may touch
    // exceeds.
    const Real slack = Real(gap_roundings) * rounding_at(position, Real{});
    const std::size_t first_neighbour = neighbour_count_;
    std::size_t count = first_neighbour;
    std::size_t close_count = 0;
    space_.for_each_ball_near(ball, [&, balls, now = scene_.now](std::uint32_t other, int across,
                                                                 int along) {
        if (count == neighbours_.size()) {
            neighbours_.resize(2 * count + 16);
            close_.resize(std::max(close_.size(), neighbours_.size()));
        }
        const LinearPart<Real>& line = balls[other].line;
        Vector<Real> offset = position - (is_uniform && line.motion == Motion::free
                                              ? line.position + line.velocity * (now - line.time)
                                              : trajectories_.position_now(other));
        if (wraps) offset = offset - scene_.image_shift(across, along);
        const Real reach = size + balls[other].radius;
        neighbours_[count] = {.offset = offset,
                              .reach = reach,
                              .other = other,
                              .across = static_cast<std::int8_t>(across),
                              .along = static_cast<std::int8_t>(along)};
        const Real rough = reach * Real(1.0 + 4.0 * contact_slop) + slack;
        const bool is_far = length_squared(offset) > rough * rough;
        close_[close_count] = static_cast<std::uint32_t>(count++);
        close_count += static_cast<std::size_t>(static_cast<int>(!is_far) &
                                                static_cast<int>(other != partner));
    });
    neighbour_count_ = count;
    close_count_ = close_count;
    bodies_[body].first_neighbour = static_cast<std::uint32_t>(first_neighbour);
    bodies_[body].neighbours = static_cast<std::uint32_t>(count - first_neighbour);
}

template <typename Real>
void ImpactCluster<Real>::scan(std::uint32_t body) {
    if (bodies_[body].is_scanned) return;
    if (!bodies_[body].is_ball()) return scan_seesaw(body);
    const std::uint32_t ball = bodies_[body].ball;
    find_neighbours(body);
    touching_.clear();
    for (std::size_t i = 0; i < close_count_; ++i) {
        Neighbour<Real>& near = neighbours_[close_[i]];
        if (!may_touch(body, near) || !scene_.balls_collide(ball, near.other)) continue;
        near.touches = true;
        touching_.push_back({static_cast<int>(near.other), near.across, near.along});
    }
    // By number: the cells must not show, not even in rounding.
    std::sort(touching_.begin(), touching_.end());
    for (const auto& [other, across, along] : touching_)
        add_ball(body, static_cast<std::uint32_t>(other), across, along, false);
    const auto is_of_event = [&](EventKind kind, std::uint32_t other) {
        const ContactPoint<Real>& first = contacts_.front();
        return first.kind == kind && first.contact.a == body && first.other == other;
    };
    space_.for_each_edge_near(ball, [&](std::uint32_t capsule, Vec2, int across, int along) {
        if (!is_of_event(EventKind::ball_edge, capsule))
            add_edge(body, capsule, across, along, false);
    });
    for (const KinematicEdge<Real>& edge : kinematic_.edges())
        if (scene_.ball_collides_with(ball, edge.capsule) &&
            !is_of_event(EventKind::kinematic_edge, edge.capsule) &&
            !(edge.is_seesaw() && knows_seesaw(body, edge.capsule)))
            add_kinematic_edge(body, edge, false);
    bodies_[body].is_scanned = true;
}

template <typename Real>
Real ImpactCluster<Real>::smaller_radius(const ContactPoint<Real>& point) const {
    if (point.is_stop) return Real{};
    const Real ours = radius_of(point.contact.a);
    return point.kind == EventKind::ball_ball ? std::min(ours, balls_.radius(point.other)) : ours;
}

template <typename Real>
Real ImpactCluster<Real>::compliance(const ContactPoint<Real>& point) const {
    Real inverse = motion_[point.contact.a].inverse_mass;
    if (point.contact.b != ImpactContact<Real>::fixed)
        inverse += motion_[point.contact.b].inverse_mass;
    return inverse;
}

template <typename Real>
bool ImpactCluster<Real>::touches_ball(std::uint32_t body) const {
    return std::any_of(contacts_.begin(), contacts_.end(), [&](const ContactPoint<Real>& point) {
        return (point.kind == EventKind::ball_ball || point.contact.is_hinged) && !point.is_apart &&
               (point.contact.a == body || point.contact.b == body);
    });
}

template <typename Real>
void ImpactCluster<Real>::note_speeds(bool stops) {
    const auto& cloth = scene_.world->model().cloth;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        Vector<Real>& velocity = motion_[i].velocity;
        const Real speed = length(velocity);
        if (bodies_[i].fastest < speed) bodies_[i].fastest = speed;
        if (!stops) continue;
        // A jam on cloth would go on with ever smaller speeds.
        const Real least =
            cloth ? Real(pressed_rounding) * square_root(Real(cloth->slide * cloth->gravity) *
                                                         radius_of(static_cast<std::uint32_t>(i)))
                  : Real{};
        if (!(speed > least + Real(residual_rounding<Real>) * bodies_[i].fastest)) velocity = {};
    }
}

template class ImpactCluster<double>;
template class ImpactCluster<DoubleDouble>;

}  // namespace carom
