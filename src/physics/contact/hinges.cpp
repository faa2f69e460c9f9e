#include "physics/contact/hinges.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/contact/paths.h"
#include "physics/contact/tolerances.h"

namespace carom {
namespace {

// Iterations at the start and at the end of a substep. x10: costs more; /10: balls on a light plank
// take turns to carry it.
constexpr int iterations = 8;

}  // namespace

void ContactHinges::list() {
    constraints_.clear();
    for (const std::uint32_t p : classification_.hinged()) {
        const ContactPair& pair = pairs_[p];
        const HeldEdge& edge = kinematics_.edge_of(pair);
        const Vec2 arm =
            bodies_.position[pair.a] - pair.normal * bodies_.radius[pair.a] - edge.seesaw.pivot;
        const double side_lever = cross(arm, perpendicular(pair.normal));
        const double inverse = bodies_.body[pair.a].inverse_mass;
        const double side =
            inverse * (1.0 + step_.spin_ease) + side_lever * side_lever / edge.seesaw.inertia;
        const double gap = pair.separation;
        constraints_.push_back(
            {.a = pair.a,
             .pair = p,
             .edge = static_cast<std::uint32_t>(&edge - std::as_const(kinematics_).edges().data()),
             .normal = pair.normal,
             .lever = cross(arm, pair.normal),
             .side_lever = side_lever,
             .target = gap > 0.0 ? gap / step_.duration : gap * step_.softness.push,
             .mass = pair.mass,
             .side_mass = side > 0.0 ? 1.0 / side : 0.0,
             .impulse = pair.impulse,
             .tangential_impulse = pair.tangential_impulse});
    }
}

// Whether balls have pressed it that way in the last substep.
bool ContactHinges::is_pressed(std::uint32_t edge, double direction) const {
    return std::ranges::any_of(constraints_, [&](const Constraint& constraint) {
        return constraint.edge == edge && constraint.impulse > 0.0 &&
               constraint.lever * direction < 0.0;
    });
}

void ContactHinges::list_stops() {
    stops_.clear();
    const std::span<HeldEdge> edges = kinematics_.edges();
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        if (!edges[i].is_seesaw) continue;
        const Seesaw& seesaw = edges[i].seesaw;
        const double arm = fastest_point(seesaw) / std::max(std::fabs(seesaw.rate), 1e-300);
        // At either stop: it may reach one, and from there the other, within the substep.
        const bool bounces =
            seesaw.stop_restitution > 0.0 && std::fabs(seesaw.rate) * arm > step_.rest_speed;
        for (const double direction : {1.0, -1.0}) {
            const double gap =
                direction > 0.0 ? seesaw.most - seesaw.angle : seesaw.angle - seesaw.least;
            if (std::isfinite(gap) && (!bounces || is_pressed(i, direction)))
                stops_.push_back({.edge = i,
                                  .direction = direction,
                                  .room = std::max(0.0, gap) / step_.duration});
        }
    }
}

double ContactHinges::energy_of_seesaws() {
    double energy = 0.0;
    for (const HeldEdge& edge : kinematics_.edges())
        if (edge.is_seesaw)
            energy += 0.5 * edge.seesaw.inertia * edge.seesaw.rate * edge.seesaw.rate;
    return energy;
}

void ContactHinges::push(const Constraint& constraint, double impulse, double tangential) {
    ContactBody& ball = bodies_.body[constraint.a];
    Seesaw& seesaw = edge_of(constraint.edge).seesaw;
    ball.velocity += (constraint.normal * impulse + perpendicular(constraint.normal) * tangential) *
                     ball.inverse_mass;
    ball.surface_speed -= tangential * ball.inverse_mass * step_.spin_ease;
    seesaw.rate -=
        (impulse * constraint.lever + tangential * constraint.side_lever) / seesaw.inertia;
}

void ContactHinges::solve(Constraint& constraint, bool is_soft) {
    const ContactBody& ball = bodies_.body[constraint.a];
    const double& rate = edge_of(constraint.edge).seesaw.rate;
    const double separating = dot(ball.velocity, constraint.normal) - rate * constraint.lever;
    const bool is_open = constraint.target > 0.0;
    double change = 0.0;
    if (is_soft) {
        const double share = is_open ? 1.0 : step_.softness.mass_share;
        const double given_back = is_open ? 0.0 : step_.softness.impulse_share;
        change = share * constraint.mass * (separating + constraint.target) +
                 given_back * constraint.impulse;
    } else {
        const double room = constraint.impulse == 0.0 ? std::max(constraint.target, 0.0) : 0.0;
        change = constraint.mass * (separating + room);
    }
    const double impulse = std::max(constraint.impulse - change, 0.0);
    push(constraint, impulse - constraint.impulse, 0.0);
    constraint.impulse = impulse;
    if (!step_.spins) return;
    const double slip = dot(ball.velocity, perpendicular(constraint.normal)) - ball.surface_speed -
                        rate * constraint.side_lever;
    const double most = pairs_[constraint.pair].friction * impulse;
    const double tangential =
        std::clamp(constraint.tangential_impulse - slip * constraint.side_mass, -most, most);
    push(constraint, 0.0, tangential - constraint.tangential_impulse);
    constraint.tangential_impulse = tangential;
}

void ContactHinges::solve_stops() {
    for (Stop& stop : stops_) {
        Seesaw& seesaw = edge_of(stop.edge).seesaw;
        const double approach = seesaw.rate * stop.direction - stop.room;
        const double impulse = std::max(0.0, stop.impulse + approach * seesaw.inertia);
        seesaw.rate -= stop.direction * (impulse - stop.impulse) / seesaw.inertia;
        stop.impulse = impulse;
    }
}

void ContactHinges::begin() {
    given_ = 0.0;
    constraints_.clear();
    if (kinematics_.edges().empty()) return;
    const double before = energy_of_seesaws();
    list();
    list_stops();
    for (const Constraint& constraint : constraints_)
        push(constraint, constraint.impulse, constraint.tangential_impulse);
    for (int i = 0; i < iterations && !(constraints_.empty() && stops_.empty()); ++i) {
        for (Constraint& constraint : constraints_)
            solve(constraint, true);
        solve_stops();
    }
    given_ = before - energy_of_seesaws();
}

void ContactHinges::report_new(std::vector<Contact>& contacts) {
    for (const Constraint& constraint : constraints_) {
        ContactPair& pair = pairs_[constraint.pair];
        if (!pair.is_new || !(constraint.impulse > 0.0)) continue;
        pair.is_new = false;
        contacts.push_back(contact_of(bodies_, pair, step_.start_time, constraint.impulse));
    }
}

void ContactHinges::give_back(const ContactPaths& paths) {
    for (Constraint& constraint : constraints_) {
        const double felt = paths.share_felt(constraint.a);
        if (felt == 1.0) continue;
        Seesaw& seesaw = edge_of(constraint.edge).seesaw;
        seesaw.rate += (1.0 - felt) *
                       (constraint.impulse * constraint.lever +
                        constraint.tangential_impulse * constraint.side_lever) /
                       seesaw.inertia;
        constraint.impulse *= felt;
        constraint.tangential_impulse *= felt;
    }
}

void ContactHinges::relax() {
    if (kinematics_.edges().empty()) return;
    for (HeldEdge& edge : kinematics_.edges())
        if (edge.is_seesaw) edge.turn(edge.seesaw_at(step_.duration), step_.duration);
    const double before = energy_of_seesaws();
    for (int i = 0; i < iterations && !(constraints_.empty() && stops_.empty()); ++i) {
        solve_stops();
        for (std::size_t k = constraints_.size(); k-- > 0;)
            solve(constraints_[k], false);
    }
    given_ += before - energy_of_seesaws();
    for (const Constraint& constraint : constraints_) {
        pairs_[constraint.pair].impulse = constraint.impulse;
        pairs_[constraint.pair].tangential_impulse = constraint.tangential_impulse;
    }
}

}  // namespace carom
