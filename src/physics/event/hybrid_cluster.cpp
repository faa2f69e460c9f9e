#include "physics/event/hybrid_cluster.h"

#include <algorithm>
#include <span>

#include "geometry/closest.h"
#include "physics/broad_phase/nearest_image.h"
#include "physics/contact/contact_memory.h"
#include "physics/event/motion/event_memory.h"
#include "physics/laws/bounce.h"

namespace carom {
namespace {

Vec2 torus_of(const World& world) {
    return world.model().wrap ? size(*world.model().wrap) : Vec2{};
}

Vec2 displacement(const World& world, Vec2 from, Vec2 to) {
    return nearest_image(world, to - from);
}

// All that the edge of a seesaw can touch, wherever it turns.
Box reach_of_seesaw(const World& world, CapsuleId id) {
    const Seesaw& seesaw = world.seesaws()[*seesaw_of(world, id)];
    const double arm = std::max(distance(seesaw.home.start, seesaw.pivot),
                                distance(seesaw.home.end, seesaw.pivot));
    return grow({seesaw.pivot, seesaw.pivot}, arm + seesaw.home.radius);
}

// Whether the hand moves what it holds up, however slowly.
bool lifts(const World& world, const Hand& hand) {
    constexpr double least_rise = 0.1;  // sine of the slope
    Vec2 moved;
    if (hand.is_on_ball) {
        if (const auto index = index_of(world, BallId{hand.number}))
            moved = displacement(world, world.balls().position[*index], hand.start_target);
    } else if (const auto index = index_of(world, CapsuleId{hand.number})) {
        const Capsule& shape = world.capsules().shape[*index];
        moved = 0.5 * ((hand.start_target - shape.start) + (hand.end_target - shape.end));
    }
    const Vec2 gravity = world.model().gravity.value_or(Vec2{});
    return dot(moved, gravity) < -least_rise * length(moved) * length(gravity);
}

}  // namespace

bool HybridCluster::is_needed(const World& world) {
    const std::vector<Hand>& hands = world.hands().each;
    if (hands.empty()) return !event_memory(world).clustered.empty();
    if (std::ranges::any_of(hands, [&](const Hand& hand) { return lifts(world, hand); }))
        return true;
    return !event_memory(world).clustered.empty() && world.balls().size() > most_pushed;
}

void HybridCluster::find(const World& world) {
    find_reach(world);
    unite_and_mark(world);
}

bool HybridCluster::find_again(const World& world) {
    was_clustered_ = is_clustered_;
    unite_and_mark(world);
    return is_clustered_ != was_clustered_;
}

bool HybridCluster::has_balls() const {
    const auto balls = std::span(is_clustered_).first(ball_count_);
    return std::ranges::find(balls, 1) != balls.end();
}

bool HybridCluster::is_everything() const {
    return std::ranges::find(is_clustered_, 0) == is_clustered_.end();
}

void HybridCluster::find_reach(const World& world) {
    const Balls& balls = world.balls();
    const double duration = world.tick_length();
    const double fall = length(world.model().gravity.value_or(Vec2{})) * duration * duration;
    reach_.resize(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i)
        reach_[i] = length(balls.velocity[i]) * duration + fall;
    for (const HeldBall& held : world.held_balls())
        if (const auto index = index_of(world, held.id))
            reach_[*index] = length(displacement(world, balls.position[*index], held.target));
}

void HybridCluster::unite_and_mark(const World& world) {
    ball_count_ = world.balls().size();
    sets_.reset(ball_count_ + world.held_capsules().size());
    near_.find(world, reach_);
    for (const NearPair& pair : near_.pairs())
        if (pair.edge == NearPair::no_edge) sets_.unite(pair.a, pair.b);
    unite_held_capsules(world);
    is_clustered_.assign(sets_.size(), 0);
    for (const BallId id : event_memory(world).clustered)
        if (const auto index = index_of(world, id))
            is_clustered_[sets_.root_of(static_cast<std::uint32_t>(*index))] = 1;
    for (const Hand& hand : world.hands().each)
        if (lifts(world, hand))
            if (const auto node = node_of(world, hand)) is_clustered_[sets_.root_of(*node)] = 1;
    // A root is the lowest node of its tree.
    for (std::uint32_t i = 0; i < sets_.size(); ++i)
        is_clustered_[i] = is_clustered_[sets_.root_of(i)];
}

// The node of what the hand holds.
std::optional<std::uint32_t> HybridCluster::node_of(const World& world, const Hand& hand) {
    if (hand.is_on_ball) {
        const auto index = index_of(world, BallId{hand.number});
        return index ? std::optional(static_cast<std::uint32_t>(*index)) : std::nullopt;
    }
    const HeldCapsule* const held = held_of(world, CapsuleId{hand.number});
    if (!held) return std::nullopt;
    const auto at = static_cast<std::size_t>(held - world.held_capsules().data());
    return static_cast<std::uint32_t>(world.balls().size() + at);
}

void HybridCluster::unite_held_capsules(const World& world) {
    const Balls& balls = world.balls();
    for (std::size_t h = 0; h < world.held_capsules().size(); ++h) {
        const HeldCapsule& held = world.held_capsules()[h];
        const auto index = index_of(world, held.id);
        if (!index) continue;
        const Capsule& shape = world.capsules().shape[*index];
        const Box box =
            held.is_seesaw
                ? reach_of_seesaw(world, held.id)
                : join(bounds(shape), bounds({held.start_target, held.end_target, shape.radius}));
        for (std::uint32_t i = 0; i < balls.size(); ++i)
            if (overlaps(grow({balls.position[i], balls.position[i]}, balls.radius[i] + reach_[i]),
                         box) &&
                kind_meets_material(world, balls.kind[i], world.capsules().material[*index]))
                sets_.unite(i, static_cast<std::uint32_t>(balls.size() + h));
    }
}

bool HybridCluster::widen(const World& world, std::uint32_t ball, Vec2 place) {
    const double moved = length(displacement(world, world.balls().position[ball], place));
    const double rounding = 1e-6 * world.balls().radius[ball];
    if (moved <= reach_[ball] + rounding) return false;
    reach_[ball] = 2.0 * moved;
    return true;
}

void HybridCluster::find_staying(const World& cluster, std::vector<BallId>& staying) {
    const Balls& balls = cluster.balls();
    const Vec2 torus = torus_of(cluster);
    stays_.assign(balls.size(), 0);
    for (const PersistentContact& pair : contact_memory(cluster).contacts) {
        if (pair.kind != ContactKind::ball_ball) {
            // A ball that lies on a seesaw.
            const auto index = index_of(cluster, pair.ball);
            if (index && seesaw_of(cluster, CapsuleId{pair.other})) stays_[*index] = 1;
            continue;
        }
        for (const BallId id : {pair.ball, BallId{pair.other}})
            if (const auto index = index_of(cluster, id)) stays_[*index] = 1;
    }
    const auto is_sunk = [&](std::uint32_t ball, Vec2 at, std::size_t edge) {
        const double radius = balls.radius[ball];
        const Capsule& shape = cluster.capsules().shape[edge];
        return separation(Disc{at, radius}, shape) < -most_overlap * radius &&
               (!cluster.model().one_way ||
                is_on_solid_side(shape, cluster.capsules().side[edge], at));
    };
    margin_.assign(balls.size(), 0.0);
    near_.find(cluster, margin_);
    for (const NearPair& pair : near_.pairs()) {
        const std::uint32_t a = pair.a;
        if (pair.edge != NearPair::no_edge) {
            const Vec2 shift{pair.across * torus.x, pair.along * torus.y};
            stays_[a] |= is_sunk(a, balls.position[a] - shift, pair.edge);
            continue;
        }
        const std::uint32_t b = pair.b;
        const double away = length(displacement(cluster, balls.position[a], balls.position[b]));
        const double gap = away - balls.radius[a] - balls.radius[b];
        if (gap < -most_overlap * std::min(balls.radius[a], balls.radius[b]))
            stays_[a] = stays_[b] = 1;
    }
    for (const HeldCapsule& held : cluster.held_capsules())
        if (const auto index = index_of(cluster, held.id))
            for (std::uint32_t i = 0; i < balls.size(); ++i)
                stays_[i] |= is_sunk(i, balls.position[i], *index);
    staying.clear();
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (stays_[i]) staying.push_back(balls.id[i]);
}

}  // namespace carom
