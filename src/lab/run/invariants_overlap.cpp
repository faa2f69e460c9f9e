#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lab/run/invariants.h"
#include "lab/run/walls.h"
#include "physics/event/motion/event_memory.h"

// Which pairs overlap, and which of them count.

namespace carom {
namespace {

// The depth that the rounding of coordinates explains. Searches for impacts take 16 roundings of
// one coordinate for a contact, and there are two places. Where that is more than two radii,
// the coordinates cannot hold the balls, and nothing is explained.
double rounding_of_depth(Vec2 at, double reach, double radius) {
    const double depth =
        32.0 * std::numeric_limits<double>::epsilon() * (std::fabs(at.x) + std::fabs(at.y) + reach);
    return depth <= 2.0 * radius ? depth : 0.0;
}

}  // namespace

bool InvariantCheck::is_exempt(const Pair& pair) const {
    return std::ranges::binary_search(exempt_, pair);
}

InvariantCheck::Pair InvariantCheck::pair_with_edge(BallId ball, CapsuleId edge) {
    return {number(ball), (std::uint64_t{1} << 32) + number(edge)};
}

template <typename Visit>
void InvariantCheck::for_each_overlap(const World& world, Visit&& visit) const {
    const Balls& balls = world.balls();
    const std::optional<Box>& torus = world.model().wrap;
    for (std::size_t at = 0; at < order_.size() && world.model().ball_ball; ++at) {
        const std::uint32_t i = order_[at];
        for (std::size_t next = at + 1; next < order_.size(); ++next) {
            const std::uint32_t j = order_[next];
            Vec2 offset = balls.position[j] - balls.position[i];
            if (!torus && offset.x > balls.radius[i] + widest_) break;
            if (torus) {
                const double wide = torus->high.x - torus->low.x;
                const double high = torus->high.y - torus->low.y;
                offset.x -= wide * std::round(offset.x / wide);
                offset.y -= high * std::round(offset.y / high);
            }
            const double reach = balls.radius[i] + balls.radius[j];
            const double depth = reach - length(offset);
            const double radius = std::min(balls.radius[i], balls.radius[j]);
            if (!(depth > rounding_of_depth(balls.position[i], reach, radius)) ||
                is_held(world, balls.id[i]) || is_held(world, balls.id[j]) ||
                (world.model().filtered && !kinds_meet(world, balls.kind[i], balls.kind[j])))
                continue;
            const std::uint32_t a = std::min(i, j);
            const std::uint32_t b = std::max(i, j);
            visit(Pair{number(balls.id[a]), number(balls.id[b])}, depth,
                  std::min(balls.radius[a], balls.radius[b]),
                  Breach{.ball = balls.id[a], .other = balls.id[b]});
        }
    }
    if (torus || !world.model().ball_edge) return;
    const Capsules& edges = world.capsules();
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const Capsule& edge = edges.shape[e];
        const double low = std::min(edge.start.x, edge.end.x) - edge.radius - widest_;
        const double high = std::max(edge.start.x, edge.end.x) + edge.radius + widest_;
        auto at = std::ranges::lower_bound(order_, low, {},
                                           [&](std::uint32_t i) { return balls.position[i].x; });
        for (; at != order_.end() && balls.position[*at].x <= high; ++at) {
            const std::uint32_t i = *at;
            const double reach = balls.radius[i] + edge.radius;
            const double depth = reach - distance_to_segment(balls.position[i], edge);
            if (!(depth > rounding_of_depth(balls.position[i], reach, balls.radius[i])) ||
                !is_wall(world, e, balls.kind[i]) || is_held(world, balls.id[i]))
                continue;
            visit(pair_with_edge(balls.id[i], edges.id[e]), depth, balls.radius[i],
                  Breach{.ball = balls.id[i], .edge = edges.id[e]});
        }
    }
}

void InvariantCheck::exempt_deep_pairs(const World& world) {
    sort(world);
    exempt_.clear();
    lifted_.clear();
    if (promise_.overlap)
        for_each_overlap(world,
                         [&](const Pair& pair, double depth, double radius, const Breach& bodies) {
                             if (depth > promise_.parted * radius)
                                 exempt(pair, depth / radius, bodies);
                         });
    std::ranges::sort(exempt_);
    std::ranges::sort(lifted_);
}

void InvariantCheck::exempt(const Pair& pair, double share, const Breach& bodies) {
    exempt_.push_back(pair);
    const double most = promise_.overlap_of_clustered;
    if (most == 0.0 || share <= most) return;
    lifted_.push_back(*bodies.ball);
    if (bodies.other) lifted_.push_back(*bodies.other);
}

std::optional<Breach> InvariantCheck::check_overlap(const World& world) {
    std::optional<Breach> deepest;
    const std::vector<Pair> exempt_before = std::exchange(exempt_, {});
    const std::vector<BallId> lifted_before = std::exchange(lifted_, {});
    // The solver itself names these balls, and those for which time stood still. All others
    // are held to what exact trajectories promise.
    const std::vector<BallId>& clustered = event_memory(world).clustered;
    const auto is_in = [](const std::vector<BallId>& balls, const Breach& pair) {
        return std::ranges::binary_search(balls, *pair.ball);
    };
    const auto other_is_in = [](const std::vector<BallId>& balls, const Breach& pair) {
        return pair.other && std::ranges::binary_search(balls, *pair.other);
    };
    const auto is_new = [&](BallId ball) { return !std::ranges::binary_search(ids_, ball); };
    for_each_overlap(world, [&](const Pair& pair, double depth, double radius, Breach breach) {
        if (!(depth > promise_.parted * radius)) return;
        if (std::ranges::binary_search(exempt_before, pair) || is_new(*breach.ball) ||
            (breach.other && is_new(*breach.other)))
            return exempt(pair, depth / radius, breach);
        const bool is_clustered =
            is_in(clustered, breach) && (!breach.other || other_is_in(clustered, breach));
        const double most = is_clustered ? promise_.overlap_of_clustered : *promise_.overlap;
        if (!(depth > most * radius)) return;
        if (is_in(lifted_before, breach) || other_is_in(lifted_before, breach))
            return exempt(pair, depth / radius, breach);
        if (deepest && depth <= deepest->amount) return;
        breach.kind = Breach::Kind::overlap;
        breach.tick = world.tick();
        breach.amount = depth;
        deepest = breach;
    });
    std::ranges::sort(exempt_);
    std::ranges::sort(lifted_);
    return deepest;
}

}  // namespace carom
