#include "physics/contact/pairs.h"

#include <algorithm>
#include <utility>

#include "physics/contact/reference_positions.h"
#include "physics/contact/tolerances.h"
#include "physics/laws/contact_material.h"
#include "physics/world/solver_access.h"

namespace carom {
namespace {

// Whether two balls have a high mass ratio, by their inverse masses. 0: a body that nothing moves.
bool are_far_apart(double inverse_of_a, double inverse_of_b) {
    return inverse_of_a > 0.0 && inverse_of_b > 0.0 &&
           std::max(inverse_of_a, inverse_of_b) >=
               contact_tolerance::high_mass_ratio * std::min(inverse_of_a, inverse_of_b);
}

}  // namespace

void ContactPairs::find(World& world) {
    ReferencePositions& reference = SolverAccess(world).memory().use<ContactMemory>().reference;
    near_.find(world, {reference.position, reference.skin});
    if (reference.order.empty()) reference.order.assign(near_.order().begin(), near_.order().end());
    body_of_.resize(reference.order.size());
    for (std::uint32_t body = 0; body < body_of_.size(); ++body)
        body_of_[reference.order[body]] = body;
}

void ContactPairs::load(const World& world, const ContactSubstep& step, ContactBodies& bodies,
                        std::span<const HeldEdge> edges) {
    rows_.assign(near_.pairs(), body_of_);
    if (!world.held_balls().empty())
        rows_.erase_if([&](const NearPair& pair) {
            return bodies.is_ball(pair.b) && bodies.is_kinematic(pair.a) &&
                   bodies.is_kinematic(pair.b);
        });
    for (const HeldEdge& edge : edges)
        add_pairs_of_edge(world, bodies, edge);
    const std::span<const NearPair> near = rows_.pairs();
    if (pairs_.capacity() < near.size()) pairs_.reserve(near.size() + near.size() / 8);
    pairs_.resize(near.size());
    const std::span<const PersistentContact> last = contact_memory(world).contacts;
    index_impulses(world, bodies, last);
    order_.arrange(near, bodies.reference, step.gravity);
    for (std::uint32_t p = 0; p < near.size(); ++p)
        pairs_[p] = pair_of(world, bodies, near[order_[p]], last);
    any_inelastic_ = any_high_mass_ratio_ = false;
    is_listed_by_body_ = false;
    kinematic_.clear();
    added_.clear();
    for (std::uint32_t p = 0; p < near.size(); ++p)
        note_kind(p);
}

void ContactPairs::note_kind(std::uint32_t p) {
    any_inelastic_ = any_inelastic_ || pairs_[p].is_inelastic;
    any_high_mass_ratio_ = any_high_mass_ratio_ || pairs_[p].has_high_mass_ratio;
    if (pairs_[p].is_kinematic) kinematic_.push_back(p);
}

ContactPair ContactPairs::pair_of(const World& world, const ContactBodies& bodies,
                                  const NearPair& near,
                                  std::span<const PersistentContact> last) const {
    const std::uint32_t ball = bodies.ball[near.a];
    const std::uint32_t b = near.b;
    const double inverse_of_a = bodies.body[near.a].inverse_mass;
    const double inverse_of_b = bodies.body[b].inverse_mass;
    const double inverse = inverse_of_a + inverse_of_b;
    ContactPair pair{.a = near.a,
                     .b = b,
                     .mass = inverse > 0.0 ? 1.0 / inverse : 0.0,
                     .radius = bodies.is_ball(b) ? std::min(bodies.radius[near.a], bodies.radius[b])
                                                 : bodies.radius[near.a],
                     .edge = near.edge,
                     .across = near.across,
                     .along = near.along,
                     .is_kinematic = b > bodies.fixed || bodies.is_kinematic(near.a) ||
                                     (bodies.is_ball(b) && bodies.is_kinematic(b)),
                     .has_high_mass_ratio = are_far_apart(inverse_of_a, inverse_of_b)};
    if (pair.is_on_edge()) {
        const Material& material = world.materials()[world.capsules().material[near.edge]];
        pair.bounces = material.restitution > 0.0 || world.model().scatter || material.kick > 0.0;
        pair.is_inelastic = pair.bounces && world.model().inelastic && !(material.kick > 0.0) &&
                            (material.restitution < 1.0 || material.soften > 0.0);
        if (world.model().spin) pair.friction = friction_of_edge(world, near.edge);
    } else {
        const std::uint32_t other = bodies.ball[b];
        const double restitution = restitution_of_balls(world, ball, other);
        pair.bounces = restitution > 0.0;
        pair.is_inelastic = pair.bounces && restitution < 1.0;
        if (world.model().spin) pair.friction = friction_of_balls(world, ball, other);
    }
    if (const PersistentContact* const then = last_impulse(world, bodies, pair, last)) {
        pair.impulse = then->impulse;
        pair.tangential_impulse = then->tangential_impulse;
        pair.is_new = false;
    }
    return pair;
}

// Every ball that could be where the edge goes in the tick. Each pair has a body of its own, since
// the points of an edge that turns differ in velocity.
void ContactPairs::add_pairs_of_edge(const World& world, ContactBodies& bodies,
                                     const HeldEdge& edge) {
    const HeldCapsule& held = world.held_capsules()[edge.held];
    const Capsule& shape = world.capsules().shape[edge.capsule];
    const Box box = join(bounds(shape), bounds({held.start_target, held.end_target, shape.radius}));
    for (std::uint32_t i = 0; i < bodies.fixed; ++i) {
        const Vec2 at = bodies.position[i];
        if (!overlaps(grow({at, at}, bodies.radius[i] + bodies.skin[i]), box)) continue;
        if (!kind_meets_material(world, world.balls().kind[bodies.ball[i]],
                                 world.capsules().material[edge.capsule]))
            continue;
        rows_.append(
            {.a = i, .b = static_cast<std::uint32_t>(bodies.body.size()), .edge = edge.capsule});
        bodies.body.push_back({});
        bodies.start_velocity.push_back({});
        bodies.displacement.push_back({});
    }
}

// By index of a ball: where its impulses of the last tick begin.
void ContactPairs::index_impulses(const World& world, const ContactBodies& bodies,
                                  std::span<const PersistentContact> last) {
    if (last.empty()) return;
    first_impulse_.resize(bodies.fixed + 1);
    std::uint32_t at = 0;
    for (std::uint32_t ball = 0; ball < bodies.fixed; ++ball) {
        while (at < last.size() && last[at].ball < world.balls().id[ball])
            ++at;
        first_impulse_[ball] = at;
    }
    first_impulse_[bodies.fixed] = static_cast<std::uint32_t>(last.size());
}

// The impulses at the end of the last tick, found by the numbers of the bodies; null if none.
const PersistentContact* ContactPairs::last_impulse(const World& world, const ContactBodies& bodies,
                                                    const ContactPair& pair,
                                                    std::span<const PersistentContact> last) const {
    if (last.empty()) return nullptr;
    const std::vector<BallId>& ids = world.balls().id;
    const std::uint32_t ball = bodies.ball[pair.a];
    const std::uint32_t other = pair.is_on_edge() ? number(world.capsules().id[pair.edge])
                                                  : number(ids[bodies.ball[pair.b]]);
    const ContactKind kind = pair.is_on_edge() ? ContactKind::ball_edge : ContactKind::ball_ball;
    for (std::uint32_t k = first_impulse_[ball]; k < first_impulse_[ball + 1]; ++k) {
        const PersistentContact& then = last[k];
        if (then.ball != ids[ball]) break;
        if (then.other == other && then.kind == kind && then.across == pair.across &&
            then.along == pair.along)
            return &then;
    }
    return nullptr;
}

void ContactPairs::store_impulses(World& world, const ContactBodies& bodies,
                                  std::vector<std::uint8_t>& touched) {
    std::vector<PersistentContact>& contacts =
        SolverAccess(world).memory().use<ContactMemory>().contacts;
    if (is_pair_order_irrelevant(world)) {
        contacts.clear();
        return;
    }
    first_impulse_.assign(bodies.fixed + 1, 0);
    for (ContactPair& pair : pairs_) {
        forget_unless_pressing(pair);
        if (pair.is_new) continue;
        ++first_impulse_[bodies.ball[pair.a] + 1];
        touched[bodies.ball[pair.a]] = 1;
        if (bodies.is_ball(pair.b)) touched[bodies.ball[pair.b]] = 1;
    }
    for (std::uint32_t i = 1; i <= bodies.fixed; ++i)
        first_impulse_[i] += first_impulse_[i - 1];
    contacts.resize(first_impulse_[bodies.fixed]);
    for (const ContactPair& pair : pairs_) {
        if (pair.is_new) continue;
        const std::uint32_t ball = bodies.ball[pair.a];
        contacts[first_impulse_[ball]++] = {
            .ball = world.balls().id[ball],
            .other = pair.is_on_edge() ? number(world.capsules().id[pair.edge])
                                       : number(world.balls().id[bodies.ball[pair.b]]),
            .kind = pair.is_on_edge() ? ContactKind::ball_edge : ContactKind::ball_ball,
            .across = pair.across,
            .along = pair.along,
            .impulse = pair.impulse,
            .tangential_impulse = pair.tangential_impulse};
    }
}

void ContactPairs::list_by_body(const ContactBodies& bodies) {
    if (is_listed_by_body_) return;
    is_listed_by_body_ = true;
    first_link_.assign(bodies.fixed, PairChain::none);
    next_link_.resize(2 * pairs_.size());
    for (std::uint32_t p = size(); p-- > 0;)
        link(p, bodies);
}

void ContactPairs::link(std::uint32_t p, const ContactBodies& bodies) {
    const ContactPair& pair = pairs_[p];
    next_link_[2 * p] = std::exchange(first_link_[pair.a], 2 * p);
    if (bodies.is_ball(pair.b))
        next_link_[2 * p + 1] = std::exchange(first_link_[pair.b], 2 * p + 1);
}

}  // namespace carom
