#include "physics/event/impact/impact_friction.h"

#include "physics/event/motion/tolerances.h"
#include "physics/laws/contact_material.h"

namespace carom {

template <typename Real>
void ImpactFriction<Real>::apply(const std::vector<std::uint32_t>& which,
                                 std::span<const Real> passed) {
    collect(which, passed);
    const bool on_cloth = scene_.world->model().cloth.has_value();
    const Real inertia(*scene_.world->model().spin);
    const int most_rounds = contacts_.size() == 1 ? 1 : most_friction_rounds;
    for (int round = 0; round < most_rounds; ++round) {
        bool is_done = true;
        for (Contact& each : contacts_) {
            const bool has_settled =
                on_cloth ? solve_on_cloth(each, inertia) : solve(each, inertia);
            is_done = is_done && has_settled;
        }
        for (Contact& each : contacts_) {
            each.impulse += each.change;
            each.lift += each.lift_change;
            if (on_cloth)
                pass_on_cloth(each, inertia);
            else
                pass(each, inertia);
        }
        if (is_done) break;
    }
}

template <typename Real>
void ImpactFriction<Real>::collect(const std::vector<std::uint32_t>& which,
                                   std::span<const Real> passed) {
    const World& world = *scene_.world;
    contacts_.clear();
    shares_.assign(cluster_.bodies().size(), 0);
    for (std::size_t i = 0; i < which.size(); ++i) {
        const ContactPoint<Real>& point = cluster_.contacts()[which[i]];
        if (!(passed[i] > Real{}) || point.is_stop) continue;
        const Real coefficient =
            point.kind == EventKind::kinematic_edge
                ? Real(friction_of_edge(world, point.other))
                : friction_.coefficient(cluster_.bodies()[point.contact.a].ball, point.support);
        const Real most = coefficient * passed[i];
        if (!(most > Real{})) continue;
        contacts_.push_back({.point = &point, .most = most});
        ++shares_[point.contact.a];
        if (point.contact.b != ImpactContact<Real>::fixed) ++shares_[point.contact.b];
    }
}

template <typename Real>
auto ImpactFriction<Real>::slip_of(const Contact& each) const -> Slip {
    const auto& contact = each.point->contact;
    const auto& bodies = cluster_.bodies();
    const Vector<Real> along = perpendicular(contact.normal);
    Slip slip;
    // As Rotation::surface_speed: an immovable ball does not turn.
    const auto add = [&](std::uint32_t body, const Real& side) {
        const ImpactBody<Real>& motion = cluster_.motion()[body];
        slip.inverse_mass += motion.inverse_mass * Real(double(shares_[body]));
        Real speed = dot(motion.velocity, along);
        if (motion.inverse_mass > Real{}) {
            speed -= side * cluster_.radius_of(body) * bodies[body].spin;
            slip.upwards += dot(bodies[body].roll, contact.normal);
        }
        slip.along += side * speed;
    };
    add(contact.a, Real(1.0));
    if (contact.is_hinged) {
        const Real& lever = each.point->side_lever;
        const ImpactBody<Real>& seesaw = cluster_.motion()[contact.b];
        slip.along -= lever * seesaw.velocity.x;
        slip.of_seesaw = lever * lever * seesaw.inverse_mass * Real(double(shares_[contact.b]));
    } else if (contact.b != ImpactContact<Real>::fixed)
        add(contact.b, Real(-1.0));
    else
        slip.along -= dot(each.point->surface_velocity, along);
    return slip;
}

// Both `solve` compute the change of the impulse. They return whether it is no more than rounding.
template <typename Real>
bool ImpactFriction<Real>::solve(Contact& each, const Real& inertia) const {
    const Slip slip = slip_of(each);
    each.change = Real{};
    if (!(slip.inverse_mass > Real{})) return true;
    const Real rolling = Real(1.0) + Real(1.0) / inertia;
    const Real wanted = each.impulse - slip.along / (slip.inverse_mass * rolling + slip.of_seesaw);
    each.change = clamped(wanted, each.most) - each.impulse;
    return !(absolute(each.change) > Real(16.0 * precision<Real>) * each.most);
}

// From what the contact passes, towards what would stop both slips, as far as its limit allows: the
// largest such share, by the root without cancellation.
template <typename Real>
bool ImpactFriction<Real>::solve_on_cloth(Contact& each, const Real& inertia) const {
    const Real zero{};
    const Real one(1.0);
    const Slip slip = slip_of(each);
    each.change = each.lift_change = zero;
    if (!(slip.inverse_mass > zero)) return true;
    const Real wanted = -slip.along / (slip.inverse_mass * (one + one / inertia));
    const Real wanted_lift = -slip.upwards * inertia / slip.inverse_mass;
    const Real square = wanted * wanted + wanted_lift * wanted_lift;
    const Real lean = each.impulse * wanted + each.lift * wanted_lift;
    const Real left = each.most * each.most - (each.impulse * each.impulse + each.lift * each.lift);
    const Real room = left > zero ? left : zero;
    Real share = one;
    if (square + lean + lean > room) {
        const Real root = square_root(lean * lean + square * room);
        share = lean > zero ? room / (lean + root) : (root - lean) / square;
    }
    each.change = wanted * share;
    each.lift_change = wanted_lift * share;
    const Real rounding = Real(16.0 * precision<Real>) * each.most;
    return !(absolute(each.change) > rounding) && !(absolute(each.lift_change) > rounding);
}

template <typename Real>
void ImpactFriction<Real>::pass(const Contact& each, const Real& inertia) {
    const auto& contact = each.point->contact;
    const Vector<Real> push = perpendicular(contact.normal) * each.change;
    const auto turn = [&](std::uint32_t body) {
        const Real inverse = cluster_.motion()[body].inverse_mass;
        cluster_.bodies()[body].spin -=
            each.change * inverse / (inertia * cluster_.radius_of(body));
    };
    cluster_.motion()[contact.a].velocity += push * cluster_.motion()[contact.a].inverse_mass;
    turn(contact.a);
    if (contact.is_hinged) {
        ImpactBody<Real>& seesaw = cluster_.motion()[contact.b];
        seesaw.velocity.x -= each.point->side_lever * each.change * seesaw.inverse_mass;
        return;
    }
    if (contact.b == ImpactContact<Real>::fixed) return;
    cluster_.motion()[contact.b].velocity -= push * cluster_.motion()[contact.b].inverse_mass;
    turn(contact.b);
}

template <typename Real>
void ImpactFriction<Real>::pass_on_cloth(const Contact& each, const Real& inertia) {
    const auto& contact = each.point->contact;
    const auto pass_to = [&](std::uint32_t index, const Real& side) {
        ImpactBody<Real>& motion = cluster_.motion()[index];
        ClusterBody<Real>& body = cluster_.bodies()[index];
        motion.velocity +=
            perpendicular(contact.normal) * (side * each.change * motion.inverse_mass);
        body.spin -= each.change * motion.inverse_mass / (inertia * cluster_.radius_of(index));
        body.roll += contact.normal * (each.lift_change * motion.inverse_mass / inertia);
    };
    pass_to(contact.a, Real(1.0));
    if (contact.b != ImpactContact<Real>::fixed) pass_to(contact.b, Real(-1.0));
}

template class ImpactFriction<double>;
template class ImpactFriction<DoubleDouble>;

}  // namespace carom
