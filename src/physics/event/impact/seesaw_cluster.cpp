#include <algorithm>
#include <cmath>

#include "physics/event/impact/impact_group.h"
#include "physics/event/motion/tolerances.h"

// Seesaws as bodies of an impact.
namespace carom {

// The seesaw is the other body of this contact point, which stands before those of its stops: the
// first one of all is that of the event.
template <typename Real>
void ImpactCluster<Real>::add_hinged(ContactPoint<Real> point, const KinematicEdge<Real>& edge) {
    const std::uint32_t body = point.contact.a;
    const Vector<Real>& normal = point.contact.normal;
    const Vector<Real> arm = bodies_[body].position - normal * radius_of(body) - edge.edge.pivot;
    point.contact.is_hinged = true;
    point.contact.surface = cross(arm, normal);
    point.side_lever = cross(arm, perpendicular(normal));
    const std::size_t at = contacts_.size();
    contacts_.push_back(point);
    contacts_[at].contact.b = add_seesaw(edge);
}

// The body of a seesaw, with its stop, where it stands at one.
template <typename Real>
std::uint32_t ImpactCluster<Real>::add_seesaw(const KinematicEdge<Real>& edge) {
    const auto index = static_cast<std::uint32_t>(&edge - kinematic_.edges().data());
    for (std::uint32_t i = 0; i < bodies_.size(); ++i)
        if (bodies_[i].seesaw == index) return i;
    const auto body = static_cast<std::uint32_t>(bodies_.size());
    const Seesaw seesaw = kinematic_.seesaw_at(edge, scene_.now);
    bodies_.push_back(
        {.ball = BallRecord<Real>::none, .seesaw = index, .fastest = Real(std::fabs(seesaw.rate))});
    motion_.push_back({{Real(seesaw.rate), Real{}}, Real(1.0) / Real(seesaw.inertia)});
    for (const double direction : {1.0, -1.0}) {
        if (!is_stopped_at(seesaw, direction)) continue;
        ContactPoint<Real> point;
        point.kind = EventKind::kinematic_edge;
        point.other = edge.capsule;
        point.is_stop = true;
        point.contact.a = body;
        point.contact.normal = {Real(-direction), Real{}};
        contacts_.push_back(point);
    }
    return body;
}

template <typename Real>
std::optional<std::uint32_t> ImpactCluster<Real>::stop_of(std::uint32_t body) const {
    for (std::uint32_t i = 0; i < contacts_.size(); ++i)
        if (contacts_[i].is_stop && contacts_[i].contact.a == body) return i;
    return std::nullopt;
}

// Whether the contact point of the ball and the seesaw is there: the scan of either finds it.
template <typename Real>
bool ImpactCluster<Real>::knows_seesaw(std::uint32_t body, std::uint32_t capsule) const {
    return std::any_of(contacts_.begin(), contacts_.end(), [&](const ContactPoint<Real>& point) {
        return point.contact.a == body && point.contact.is_hinged && point.other == capsule;
    });
}

// All balls that touch the seesaw. Those that have been scanned know it already.
template <typename Real>
void ImpactCluster<Real>::scan_seesaw(std::uint32_t body) {
    bodies_[body].is_scanned = true;
    const KinematicEdge<Real>& edge = kinematic_.edges()[bodies_[body].seesaw];
    const Edge<Real> shape = edge.edge.at(scene_.now);
    for (std::uint32_t ball = 0; ball < balls_.size(); ++ball) {
        const std::uint32_t known = body_of_[ball];
        if (known != BallRecord<Real>::none && bodies_[known].is_scanned) continue;
        if (!scene_.ball_collides_with(ball, edge.capsule)) continue;
        const Real& radius = balls_.radius(ball);
        const Vector<Real> position = trajectories_.position_now(ball);
        const Real slop =
            radius * Real(contact_slop) + Real(gap_roundings) * rounding_at(position, radius);
        if (contact_with(shape, position, radius).gap > slop) continue;
        const std::uint32_t other = add_body(ball);
        if (!knows_seesaw(other, edge.capsule)) add_kinematic_edge(other, edge, true);
    }
}

// The approach of a ball and a seesaw, or of a seesaw and its stop, below which it is rounding.
template <typename Real>
Real ImpactGroup<Real>::least_turn_of(const ContactPoint<Real>& point) const {
    const ImpactContact<Real>& contact = point.contact;
    Real speeds = cluster_.bodies()[contact.a].fastest;
    if (contact.is_hinged)
        speeds += cluster_.bodies()[contact.b].fastest * absolute(contact.lever());
    return Real(residual_rounding<Real>) * speeds;
}

template <typename Real>
void ImpactGroup<Real>::add_stops() {
    const std::size_t count = approaching_.size();
    for (std::size_t at = 0; at < count; ++at) {
        const ImpactContact<Real>& contact = cluster_.contacts()[approaching_[at]].contact;
        if (!contact.is_hinged) continue;
        const auto stop = cluster_.stop_of(contact.b);
        if (stop && !std::count(approaching_.begin(), approaching_.end(), *stop))
            approaching_.push_back(*stop);
    }
}

template <typename Real>
std::size_t ImpactGroup<Real>::count_without_stops() const {
    if (!scene_.world->model().hinged) return approaching_.size();
    return static_cast<std::size_t>(
        std::count_if(approaching_.begin(), approaching_.end(),
                      [&](std::uint32_t i) { return !cluster_.contacts()[i].is_stop; }));
}

// After the impulses of a round: a rate that is rounding, of a seesaw at a stop that has taken an
// impulse, is none.
template <typename Real>
void ImpactGroup<Real>::hold_at_stop(std::size_t at) {
    ImpactBody<Real>& seesaw = cluster_.motion()[cluster_.contacts()[approaching_[at]].contact.a];
    const Real rounding = Real(residual_rounding<Real>) * passed_[at] * seesaw.inverse_mass;
    if (!(absolute(seesaw.velocity.x) > rounding)) seesaw.velocity.x = Real{};
}

#define CAROM_FOR(Real)                                                                            \
    template void ImpactCluster<Real>::add_hinged(ContactPoint<Real>, const KinematicEdge<Real>&); \
    template std::uint32_t ImpactCluster<Real>::add_seesaw(const KinematicEdge<Real>&);            \
    template std::optional<std::uint32_t> ImpactCluster<Real>::stop_of(std::uint32_t) const;       \
    template bool ImpactCluster<Real>::knows_seesaw(std::uint32_t, std::uint32_t) const;           \
    template void ImpactCluster<Real>::scan_seesaw(std::uint32_t);                                 \
    template Real ImpactGroup<Real>::least_turn_of(const ContactPoint<Real>&) const;               \
    template void ImpactGroup<Real>::add_stops();                                                  \
    template std::size_t ImpactGroup<Real>::count_without_stops() const;                           \
    template void ImpactGroup<Real>::hold_at_stop(std::size_t);
CAROM_FOR(double)
CAROM_FOR(DoubleDouble)
#undef CAROM_FOR

}  // namespace carom
