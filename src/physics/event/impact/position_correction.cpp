#include "physics/event/impact/position_correction.h"

#include <algorithm>

#include "physics/event/motion/tolerances.h"

namespace carom {

template <typename Real>
bool PositionCorrection<Real>::is_paid() const {
    const Model& model = scene_.world->model();
    return model.gravity && loses_energy(model) && !model.cloth;
}

template <typename Real>
void PositionCorrection<Real>::apply(const Real& lost) {
    if (!is_paid() && !scene_.world->model().cloth) return;
    moved_.clear();
    separate();
    if (!moved_.empty() && is_paid()) pay(lost);
}

template <typename Real>
void PositionCorrection<Real>::separate() {
    const bool on_cloth = scene_.world->model().cloth.has_value();
    const Real bearable(on_cloth ? overlap_heights_on_cloth * cloth_rest_height
                                 : overlap_heights * moving_rest_height);
    for (const ContactPoint<Real>& point : cluster_.contacts()) {
        if (point.kind == EventKind::kinematic_edge && on_cloth) {
            move_out_of(point);
            continue;
        }
        if (point.kind != EventKind::ball_ball) continue;
        const Real small = cluster_.smaller_radius(point);
        if (!(point.gap < -bearable * small)) continue;
        const Real depth = std::min(-point.gap, Real(most_correction) * small);
        const Vector<Real>& normal = point.contact.normal;
        const Allowed ours = allowed(point.contact.a, normal * depth);
        const Allowed theirs = allowed(point.contact.b, -normal * depth);
        const auto gain_of = [&](const Allowed& room, const Real& side) {
            return room.inverse_mass * (side * dot(room.displacement, normal) / depth);
        };
        const Real gain = gain_of(ours, Real(1.0)) + gain_of(theirs, Real(-1.0));
        if (!(gain > Real{})) continue;
        const auto go = [&](std::uint32_t index, const Allowed& room) {
            if (!(room.inverse_mass > Real{})) return;
            // No further than was tried. Yet a bent edge may bar a part of a displacement.
            Vector<Real> displacement =
                room.displacement * std::min(Real(1.0), room.inverse_mass / gain);
            if (!deflect(cluster_.bodies()[index], displacement)) move(index, displacement);
        };
        go(point.contact.a, ours);
        go(point.contact.b, theirs);
        cluster_.note_correction();
    }
}

// A ball on cloth slips when it leaves the edge that pushes it, and rolls when it comes back, which
// it does more slowly: impact by impact it would sink into the edge.
template <typename Real>
void PositionCorrection<Real>::move_out_of(const ContactPoint<Real>& point) {
    if (!(point.gap < Real{})) return;
    const Real depth = std::min(-point.gap, Real(most_correction) * cluster_.smaller_radius(point));
    const Allowed room = allowed(point.contact.a, point.contact.normal * depth);
    if (!(room.inverse_mass > Real{})) return;
    move(point.contact.a, room.displacement);
    cluster_.note_correction();
}

template <typename Real>
void PositionCorrection<Real>::move(std::uint32_t index, const Vector<Real>& displacement) {
    ClusterBody<Real>& body = cluster_.bodies()[index];
    if (!body.is_moved) moved_.push_back({index, body.position});
    body.position += displacement;
    body.is_moved = true;
}

// The potential energy that the bodies have gained.
template <typename Real>
Real PositionCorrection<Real>::lifted() const {
    Real sum{};
    for (const Start& start : moved_)
        sum -= dot(scene_.field.gravity, cluster_.bodies()[start.body].position - start.position) /
               cluster_.motion()[start.body].inverse_mass;
    return sum;
}

template <typename Real>
auto PositionCorrection<Real>::momentum() const -> Momentum {
    bool is_alone = true;
    for (const ContactPoint<Real>& point : cluster_.contacts())
        is_alone = is_alone && (point.is_apart || (point.kind == EventKind::ball_ball &&
                                                   cluster_.bodies()[point.contact.a].is_changed &&
                                                   cluster_.bodies()[point.contact.b].is_changed));
    Momentum all;
    Real mass{};
    for (std::size_t i = 0; i < cluster_.bodies().size(); ++i) {
        const ImpactBody<Real>& body = cluster_.motion()[i];
        if (!cluster_.bodies()[i].is_changed || !(body.inverse_mass > Real{})) continue;
        all.kinetic += Real(0.5) * length_squared(body.velocity) / body.inverse_mass;
        all.velocity += body.velocity / body.inverse_mass;
        mass += Real(1.0) / body.inverse_mass;
    }
    if (!is_alone || !(mass > Real{})) {
        all.velocity = {};
        return all;
    }
    all.velocity = all.velocity / mass;
    all.kinetic -= Real(0.5) * mass * length_squared(all.velocity);
    return all;
}

// One share of all velocities keeps every contact point at rest or separating.
template <typename Real>
void PositionCorrection<Real>::pay(const Real& lost) {
    const Real gain = lifted();
    if (!(gain > lost)) return;
    const Momentum all = momentum();
    const Real most = Real(most_paid) * std::max(Real{}, all.kinetic) + std::max(Real{}, lost);
    if (gain > most)
        for (const Start& start : moved_) {
            Vector<Real>& position = cluster_.bodies()[start.body].position;
            position = start.position + (position - start.position) * (most / gain);
        }
    const Real owed = std::min(gain, most) - lost;
    if (!(owed > Real{} && owed < all.kinetic)) return;
    const Real share = square_root(Real(1.0) - owed / all.kinetic);
    for (std::size_t i = 0; i < cluster_.bodies().size(); ++i) {
        ImpactBody<Real>& body = cluster_.motion()[i];
        if (!cluster_.bodies()[i].is_changed || !(body.inverse_mass > Real{})) continue;
        body.velocity = all.velocity + (body.velocity - all.velocity) * share;
    }
}

// Whether a ball would be displaced into another one, or through it, deeper than it is in there.
// Distance along a displacement is convex, so no part of it leads deeper than its nearest point.
template <typename Real>
bool PositionCorrection<Real>::enters_ball(const ClusterBody<Real>& body,
                                           const Vector<Real>& displacement) const {
    const Real size = balls_.radius(body.ball);
    bool enters = false;
    space_.for_each_ball_near(body.ball, [&](std::uint32_t other, int across, int along) {
        if (!scene_.balls_collide(body.ball, other)) return;
        const std::uint32_t index = cluster_.body_of(other);
        const Vector<Real> place =
            index != BallRecord<Real>::none
                ? cluster_.bodies()[index].position
                : state_at(balls_.trajectory(other), scene_.field, scene_.now).position;
        const Vector<Real> offset = body.position - place - scene_.image_shift(across, along);
        const Real reach = size + balls_.radius(other);
        const Real bearable =
            Real(most_correction_into_ball) * std::min(size, balls_.radius(other));
        const Real nearest = std::clamp(-dot(offset, displacement) / length_squared(displacement),
                                        Real{}, Real(1.0));
        const Real gap = length(offset + displacement * nearest) - reach;
        enters = enters || (gap < -bearable && gap < length(offset) - reach);
    });
    return enters;
}

// Turns a displacement along the first edge into which it would lead deeper than the ball is now.
// Returns whether there is one. An edge is convex, so only a displacement against the normal can
// lead deeper. By that it is judged, not by the depths alone: deeper by their rounding in each
// impact, a ball at distant coordinates would sink without end.
template <typename Real>
bool PositionCorrection<Real>::deflect(const ClusterBody<Real>& body,
                                       Vector<Real>& displacement) const {
    const Vector<Real> there = body.position + displacement;
    const Real size = balls_.radius(body.ball);
    bool enters = false;
    const auto meet = [&](std::uint32_t capsule, Vec2 shift, int, int) {
        if (enters) return;
        const Edge<Real> edge(scene_.world->capsules().shape[capsule], shift);
        const Real gap = contact_with(edge, there, size).gap;
        if (!(gap < Real{})) return;
        const auto here = contact_with(edge, body.position, size);
        const Real inwards = -dot(displacement, here.normal);
        const Real rounding = Real(component_rounding<Real>) * length(displacement);
        if (!(gap < here.gap && inwards > rounding)) return;
        enters = true;
        displacement += here.normal * inwards;
    };
    space_.for_each_edge_around(body.ball, space_.cells().spot_of(Vec2(there)), meet);
    return enters;
}

template <typename Real>
auto PositionCorrection<Real>::allowed(std::uint32_t index, const Vector<Real>& displacement) const
    -> Allowed {
    const ClusterBody<Real>& body = cluster_.bodies()[index];
    const Motion motion = balls_[body.ball].line.motion;
    if (!body.is_changed || motion == Motion::held || motion == Motion::resting) return {};
    Vector<Real> left = displacement;
    if (deflect(body, left) && deflect(body, left)) return {};
    const Real harmless = Real(most_correction_into_ball) * balls_.radius(body.ball);
    if (length_squared(left) > harmless * harmless && enters_ball(body, left)) return {};
    return {left, cluster_.motion()[index].inverse_mass};
}

template class PositionCorrection<double>;
template class PositionCorrection<DoubleDouble>;

}  // namespace carom
