#include "physics/event/impact/position_correction.h"

#include <algorithm>

#include "physics/event/motion/tolerances.h"

namespace carom {

template <typename Real>
void PositionCorrection<Real>::apply() {
    const Model& model = scene_.world->model();
    const bool on_cloth = model.cloth.has_value();
    if (!(model.gravity && model.inelastic) && !on_cloth) return;
    const Real allowed(on_cloth ? overlap_heights_on_cloth * cloth_rest_height
                                : overlap_heights * moving_rest_height);
    for (const ContactPoint<Real>& point : cluster_.contacts()) {
        if (point.kind == EventKind::kinematic_edge && on_cloth) {
            move_out_of(point);
            continue;
        }
        if (point.kind != EventKind::ball_ball) continue;
        const Real small = cluster_.smaller_radius(point);
        if (!(point.gap < -allowed * small)) continue;
        const Real depth = std::min(-point.gap, Real(most_correction) * small);
        const Vector<Real>& normal = point.contact.normal;
        const Real ours = share_of(point.contact.a, normal * depth);
        const Real theirs = share_of(point.contact.b, -normal * depth);
        if (!(ours + theirs > Real{})) continue;
        const Vector<Real> displacement = normal * (depth / (ours + theirs));
        ClusterBody<Real>& a = cluster_.bodies()[point.contact.a];
        ClusterBody<Real>& b = cluster_.bodies()[point.contact.b];
        a.position += displacement * ours;
        b.position -= displacement * theirs;
        a.is_moved = b.is_moved = true;
        cluster_.note_correction();
    }
}

// A ball on cloth slips when it leaves the edge that pushes it, and rolls when it comes back, which
// it does more slowly: impact by impact it would sink into the edge.
template <typename Real>
void PositionCorrection<Real>::move_out_of(const ContactPoint<Real>& point) {
    if (!(point.gap < Real{})) return;
    const Real depth = std::min(-point.gap, Real(most_correction) * cluster_.smaller_radius(point));
    const Vector<Real> displacement = point.contact.normal * depth;
    if (!(share_of(point.contact.a, displacement) > Real{})) return;
    ClusterBody<Real>& body = cluster_.bodies()[point.contact.a];
    body.position += displacement;
    body.is_moved = true;
    cluster_.note_correction();
}

// Whether a ball would be displaced into another one, deeper than it is in there.
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
        const Real allowed = Real(most_correction_into_ball) * std::min(size, balls_.radius(other));
        const Real gap = length(offset + displacement) - reach;
        enters = enters || (gap < -allowed && gap < length(offset) - reach);
    });
    return enters;
}

// The body's inverse mass if it may be displaced so far, which may not take it into an edge or
// another ball; else 0.
template <typename Real>
Real PositionCorrection<Real>::share_of(std::uint32_t index,
                                        const Vector<Real>& displacement) const {
    const ClusterBody<Real>& body = cluster_.bodies()[index];
    const LinearPart<Real>& line = balls_[body.ball].line;
    const bool may_give_way = line.motion == Motion::free || is_on_cloth(line);
    if (!body.is_changed || !may_give_way) return Real{};
    const Vector<Real> there = body.position + displacement;
    const Real size = balls_.radius(body.ball);
    bool is_barred = false;
    const auto bar = [&](std::uint32_t capsule, Vec2 shift, int, int) {
        const Edge<Real> edge(scene_.world->capsules().shape[capsule], shift);
        const Real gap = contact_with(edge, there, size).gap;
        is_barred =
            is_barred || (gap < Real{} && gap < contact_with(edge, body.position, size).gap);
    };
    space_.for_each_edge_around(body.ball, space_.cells().spot_of(Vec2(there)), bar);
    const Real harmless = Real(most_correction_into_ball) * size;
    if (!is_barred && length_squared(displacement) > harmless * harmless)
        is_barred = enters_ball(body, displacement);
    return is_barred ? Real{} : cluster_.motion()[index].inverse_mass;
}

template class PositionCorrection<double>;
template class PositionCorrection<DoubleDouble>;

}  // namespace carom
