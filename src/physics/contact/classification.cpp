#include "physics/contact/classification.h"

#include <algorithm>
#include <cmath>

#include "geometry/closest.h"
#include "physics/contact/tolerances.h"
#include "physics/laws/contact_material.h"
#include "physics/laws/curve.h"

namespace carom {

double restitution_of(const World& world, const ContactBodies& bodies, const ContactPair& pair,
                      double approach) {
    if (pair.is_on_edge()) return restitution_of_edge(world, pair.edge, approach);
    return restitution_of_balls(world, bodies.ball[pair.a], bodies.ball[pair.b]);
}

double closing_gap(const ContactBodies& bodies) {
    return contact_tolerance::closing_margin * bodies.smallest_radius;
}

namespace {

// Where centres coincide any normal does. Balls in one place part fastest if their normals point
// all round, so each pair has one of its own, by the numbers of its balls; a ball on the spine of
// an edge goes up.
Vec2 normal_of_coincident(const World& world, const ContactBodies& bodies, const ContactPair& pair,
                          Vec2 gravity) {
    if (pair.is_on_edge()) return direction(-gravity, {0.0, 1.0});
    const auto part = [&](double share) {
        const double place = share * number(world.balls().id[bodies.ball[pair.a]]) +
                             share * share * number(world.balls().id[bodies.ball[pair.b]]);
        return place - std::floor(place) - 0.5;
    };
    // Powers of the plastic number's inverse fill a square evenly.
    return direction({part(0.7548776662466927), part(0.5698402909980532)}, {0.0, 1.0});
}

}  // namespace

// The normal and the separation.
template <Terms terms>
inline void ContactClassification::measure(const World& world, ContactPair& pair) {
    Vec2 offset;
    double reach = bodies_.radius[pair.a];
    if (!pair.is_on_edge()) {
        offset = bodies_.position[pair.a] - bodies_.position[pair.b];
        if (terms.wrap()) offset = nearest_image(offset, step_.torus);
        reach += bodies_.radius[pair.b];
    } else {
        Vec2 at = bodies_.position[pair.a];
        if (terms.wrap()) at -= Vec2{pair.across * step_.torus.x, pair.along * step_.torus.y};
        const Capsule& shape = world.capsules().shape[pair.edge];
        offset = at - closest_point(shape.start, shape.end, at);
        reach += shape.radius;
        if (terms.special() && pair.b > bodies_.fixed)
            bodies_.start_velocity[pair.b] = bodies_.body[pair.b].velocity =
                surface_velocity(kinematics_.edge_of(pair), shape, at);
    }
    const double away = length(offset);
    pair.separation = away - reach;
    if (away > 1e-150)
        pair.normal = offset * (1.0 / away);
    else
        pair.normal = normal_of_coincident(world, bodies_, pair, step_.gravity);
    if (terms.special() && pair.b > bodies_.fixed) hinge(pair);
}

// The effective mass with a seesaw, which turns.
void ContactClassification::hinge(ContactPair& pair) const {
    const HeldEdge& edge = kinematics_.edge_of(pair);
    pair.is_hinged = edge.is_seesaw;
    if (!edge.is_seesaw) return;
    const Vec2 arm = bodies_.position[pair.a] - edge.seesaw.pivot;
    const double lever = cross(arm, pair.normal);
    const double compliance =
        bodies_.body[pair.a].inverse_mass + lever * lever / edge.seesaw.inertia;
    pair.mass = compliance > 0.0 ? 1.0 / compliance : 0.0;
}

// Whether a kinematic body pushes the ball faster than it would bounce off a fixed one.
bool ContactClassification::is_pushed(const World& world, const ContactPair& pair,
                                      double approach) const {
    if (pair.is_hinged) return false;
    if (pair.b > bodies_.fixed && kinematics_.edge_of(pair).is_driven) return false;
    const bool by_a = bodies_.is_ball(pair.b) && bodies_.is_kinematic(pair.a);
    const std::uint32_t pusher = by_a ? pair.a : pair.b;
    const std::uint32_t ball = by_a ? pair.b : pair.a;
    const Vec2 normal = by_a ? -pair.normal : pair.normal;
    const double surface = dot(bodies_.start_velocity[pusher], normal);
    if (!(surface > 0.0)) return false;
    const double speed = dot(bodies_.start_velocity[ball], normal);
    return -restitution_of(world, bodies_, pair, std::max(0.0, approach)) * speed <= surface;
}

void ContactClassification::count_contacts(bool is_reloaded) {
    contacts_on_.clear();
    if (!pairs_.any_inelastic() || step_.gravity == Vec2{}) return;
    contacts_on_.assign(bodies_.body.size(), 0);
    // Without branches: whether a pair presses is a toss-up, which would be mispredicted.
    const auto count = [&](const ContactPair& pair) {
        const bool presses = pair.impulse > 0.0;
        for (const std::uint32_t body : {pair.a, pair.b}) {
            std::uint8_t& contacts = contacts_on_[body];
            contacts += static_cast<std::uint8_t>(
                presses & (contacts < contact_tolerance::enclosed_contacts));
        }
    };
    if (is_reloaded)
        for (const ContactPair& pair : pairs_.all())
            count(pair);
    else
        for (const std::uint32_t p : constraints_)
            count(pairs_[p]);
}

bool ContactClassification::is_enclosed(const ContactPair& pair) const {
    if (!pair.is_inelastic || contacts_on_.empty()) return false;
    return contacts_on_[pair.a] >= contact_tolerance::enclosed_contacts &&
           (!bodies_.is_ball(pair.b) ||
            contacts_on_[pair.b] >= contact_tolerance::enclosed_contacts);
}

// Whether a ball meets a piece of a curve because the curve turns, and not because gravity presses
// the ball on it in this substep.
bool ContactClassification::is_led_by_curve(const World& world, const ContactPair& pair,
                                            double approach) const {
    if (!world.model().curved || pair.b != bodies_.fixed) return false;
    const Joints& joints = world.capsules().joints[pair.edge];
    if (joints[0] == no_joint && joints[1] == no_joint) return false;
    if (!(approach > contact_tolerance::least_turn * step_.rest_speed)) return false;
    return pair.separation > 0.0 ||
           curve_bounce(world, pair.edge,
                        {.position = bodies_.position[pair.a],
                         .velocity = bodies_.start_velocity[pair.a],
                         .normal = pair.normal,
                         .reach = bodies_.radius[pair.a] + world.capsules().shape[pair.edge].radius,
                         .restitution = 0.0})
               .is_flat;
}

// Whether the pair moves more than `most_travel` radii in the substep.
inline bool ContactClassification::is_fast(const ContactPair& pair, Vec2 relative) const {
    const double square = length_squared(relative);
    if (square <= slowest_fast_square_) return false;
    const double most = contact_tolerance::most_travel * pair.radius / step_.duration;
    return square > most * most;
}

template <Terms terms>
inline ContactState ContactClassification::state_of(const World& world,
                                                    const ContactPair& pair) const {
    using enum ContactState;
    Vec2 relative = bodies_.start_velocity[pair.a] - bodies_.start_velocity[pair.b];
    const Vec2 without_fall = relative;
    // Without special terms all balls move.
    const bool is_b_kinematic =
        terms.special() ? bodies_.is_kinematic(pair.b) : !bodies_.is_ball(pair.b);
    if (is_b_kinematic) relative += step_.gravity * step_.duration;
    if (terms.special() && bodies_.is_kinematic(pair.a)) relative -= step_.gravity * step_.duration;
    const double approach = -dot(relative, pair.normal);
    if (pair.separation - approach * step_.duration > closing_gap_) return idle;
    if (terms.special() && pair.mass == 0.0) return approach > 0.0 ? ccd : idle;
    const bool pushed = terms.special() && pair.is_kinematic && is_pushed(world, pair, approach);
    if (terms.special() && is_led_by_curve(world, pair, -dot(without_fall, pair.normal)))
        return ccd;
    // A kinematic body that touches goes on pushing, however far its target: it can be held back.
    // Hardly any pair is fast, so the branch predictor is right here. Whether a pair at rest
    // approaches is a toss-up, so that is asked last.
    if (is_fast(pair, relative) && approach > 0.0 && !(pushed && pair.separation <= 0.0))
        return ccd;
    if (pair.bounces && !pushed) {
        if (step_.rest_speed == 0.0) return approach > 0.0 ? ccd : idle;
        // Bodies that overlap meet at once, before gravity has made the approach any faster.
        const auto stays = [&] {
            return pair.separation < 0.0 &&
                   (pair.impulse > 0.0 || -dot(without_fall, pair.normal) < step_.rest_speed);
        };
        if (approach >= step_.rest_speed && !stays() && !is_enclosed(pair)) return ccd;
    }
    if (terms.special() && world.model().one_way && pair.is_on_edge() &&
        world.capsules().side[pair.edge] != Side::both) {
        const bool engaged = pair.impulse > 0.0 || pair.separation > -0.5 * pair.radius;
        if (!engaged ||
            !is_on_solid_side(world.capsules().shape[pair.edge], world.capsules().side[pair.edge],
                              bodies_.position[pair.a]))
            return idle;
    }
    return constraint;
}

template <Terms terms>
void ContactClassification::classify_all(const World& world) {
    ccd_.clear();
    hinged_.clear();
    constraints_.resize(pairs_.size());
    std::size_t constraint_count = 0;
    double deepest = 0.0;
    std::uint32_t next = 0;
    for (ContactPair& pair : pairs_.all()) {
        const std::uint32_t p = next++;
        measure<terms>(world, pair);
        pair.state = state_of<terms>(world, pair);
        pair.has_settled = false;
        if (pair.state != ContactState::constraint) {
            pair.impulse = pair.tangential_impulse = 0.0;
            if (pair.state == ContactState::ccd) ccd_.push_back(p);
            continue;
        }
        deepest = std::min(deepest, pair.separation);
        if (terms.special() && pair.is_hinged) {
            hinged_.push_back(p);
            continue;
        }
        constraints_[constraint_count++] = p;
    }
    constraints_.resize(constraint_count);
    deepest_ = deepest;
}

void ContactClassification::classify(const World& world) {
    closing_gap_ = closing_gap(bodies_);
    const double slowest =
        contact_tolerance::most_travel * bodies_.smallest_radius / step_.duration;
    slowest_fast_square_ = slowest * slowest;
    with_terms(terms_of(world), [&]<Terms terms>() { classify_all<terms>(world); });
}

}  // namespace carom
