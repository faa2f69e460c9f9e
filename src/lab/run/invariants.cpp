#include "lab/run/invariants.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "lab/run/fastest_within.h"
#include "lab/run/time_check.h"
#include "physics/event/motion/event_memory.h"

namespace carom {
namespace {

bool is_moved(const World& world, CapsuleId id) {
    return is_held(world, id) ||
           std::ranges::find(world.flippers(), id, &Flipper::capsule) != world.flippers().end() ||
           moves_by_itself(world, id);
}

// Whether the edge blocks all balls of that kind, from both sides.
bool is_wall(const World& world, std::size_t edge, ClassIndex kind) {
    const Capsules& edges = world.capsules();
    return (!world.model().one_way || edges.side[edge] == Side::both) &&
           (!world.model().filtered || kind_meets_material(world, kind, edges.material[edge])) &&
           !is_moved(world, edges.id[edge]);
}

// Whether all of these edges are where they were, and stop all balls from both sides.
bool are_closed(const World& world, const std::vector<std::pair<CapsuleId, Capsule>>& outlines) {
    for (const auto& [id, shape] : outlines) {
        const auto index = index_of(world, id);
        if (!index || !(world.capsules().shape[*index] == shape)) return false;
        for (ClassIndex kind = 0; kind < world.kinds().size(); ++kind)
            if (!is_wall(world, *index, kind)) return false;
    }
    return world.model().ball_edge;
}

double distance_to_segment(Vec2 point, const Capsule& edge) {
    const Vec2 span = edge.end - edge.start;
    const double whole = length_squared(span);
    const double share =
        whole > 0.0 ? std::clamp(dot(point - edge.start, span) / whole, 0.0, 1.0) : 0.0;
    return length(point - edge.start - span * share);
}

bool are_on_two_sides(Vec2 a, Vec2 b, Vec2 start, Vec2 end) {
    const double first = cross(end - start, a - start);
    const double second = cross(end - start, b - start);
    return (first > 0.0 && second < 0.0) || (first < 0.0 && second > 0.0);
}

// The depth that the rounding of coordinates explains. Searches for impacts take 16 roundings of
// one coordinate for a contact, and there are two places. Where that is more than two radii,
// the coordinates cannot hold the balls, and nothing is explained.
double rounding_of_depth(Vec2 at, double reach, double radius) {
    const double depth =
        32.0 * std::numeric_limits<double>::epsilon() * (std::fabs(at.x) + std::fabs(at.y) + reach);
    return depth <= 2.0 * radius ? depth : 0.0;
}

constexpr std::uint64_t edge_mark = std::uint64_t{1} << 32;

}  // namespace

InvariantCheck::InvariantCheck(const Scene& scene, SolverKind solver)
    : solver_(solver),
      promise_(promise_of(solver)),
      energy_(promise_, solver != SolverKind::contact, scene.world),
      escape_(scene) {
    const World& world = scene.world;
    for (const std::vector<CapsuleId>& outline : scene.outlines)
        for (const CapsuleId id : outline)
            if (const auto index = index_of(world, id))
                outlines_.push_back({id, world.capsules().shape[*index]});
    escaped_ = escape_.escaped(world);
    exempt_deep_pairs(world);
    remember(world);
}

void InvariantCheck::change_solver(SolverKind solver, const World& world) {
    if (solver == solver_) return;
    solver_ = solver;
    promise_ = promise_of(solver);
    energy_.change_promise(promise_, solver != SolverKind::contact, world);
    exempt_deep_pairs(world);
}

void InvariantCheck::exempt_deep_pairs(const World& world) {
    sort(world);
    exempt_.clear();
    if (promise_.overlap)
        for_each_overlap(world, [&](const Pair& pair, double depth, double radius, const Breach&) {
            if (depth > promise_.parted * radius) exempt_.push_back(pair);
        });
    std::ranges::sort(exempt_);
}

void InvariantCheck::note_start(const World& world) {
    energy_.begin(world);
    if (world.stamps() == stamps_) return;
    escape_.note_births(world);
    energy_.take_over(world);
    escaped_ = escape_.escaped(world);
    exempt_deep_pairs(world);
    remember(world);
}

std::optional<Breach> InvariantCheck::note_tick(const World& world, bool stood_still,
                                                std::span<const Contact> contacts) {
    std::optional<Breach> breach = check_finite(world);
    if (breach) return breach;
    escape_.note_births(world);
    sort(world);
    if (count_too_small(promise_, world) > 0) {
        energy_.restart(world);
        escaped_ = escape_.escaped(world);
        exempt_deep_pairs(world);
        remember(world);
        return std::nullopt;
    }
    if (const auto gain =
            energy_.check(world, contacts, ids_ == world.balls().id, !exempt_.empty()))
        breach = Breach{.kind = Breach::Kind::energy, .tick = world.tick(), .amount = *gain};
    if (!breach && promise_.keeps_sides) breach = check_sides(world, contacts);
    if (!breach && promise_.keeps_sides) {
        const std::size_t escaped = escape_.escaped(world);
        if (escaped > escaped_ && are_closed(world, outlines_))
            breach = Breach{.kind = Breach::Kind::escape,
                            .tick = world.tick(),
                            .amount = static_cast<double>(escaped - escaped_)};
    }
    if (!breach && promise_.overlap) breach = check_overlap(world);
    if (!breach) breach = check_time(world, stood_still);
    remember(world);
    return breach;
}

void InvariantCheck::remember(const World& world) {
    stamps_ = world.stamps();
    energy_.remember(world);
    tick_ = world.tick();
    ids_ = world.balls().id;
    position_ = world.balls().position;
    velocity_ = world.balls().velocity;
}

void InvariantCheck::sort(const World& world) {
    const Balls& balls = world.balls();
    order_.resize(balls.size());
    std::iota(order_.begin(), order_.end(), 0u);
    std::ranges::sort(order_, [&](std::uint32_t a, std::uint32_t b) {
        if (balls.position[a].x != balls.position[b].x)
            return balls.position[a].x < balls.position[b].x;
        return a < b;
    });
    widest_ = balls.size() == 0 ? 0.0 : *std::ranges::max_element(balls.radius);
}

std::optional<Breach> InvariantCheck::check_finite(const World& world) const {
    const Balls& balls = world.balls();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const Vec2 place = balls.position[i];
        const Vec2 velocity = balls.velocity[i];
        for (const double number : {place.x, place.y, velocity.x, velocity.y}) {
            if (std::isfinite(number)) continue;
            return Breach{.kind = Breach::Kind::not_finite,
                          .tick = world.tick(),
                          .ball = balls.id[i],
                          .amount = number};
        }
    }
    return std::nullopt;
}

std::optional<Breach> InvariantCheck::check_sides(const World& world,
                                                  std::span<const Contact> contacts) const {
    const Balls& balls = world.balls();
    const Capsules& edges = world.capsules();
    if (world.model().wrap || !world.model().ball_edge) return std::nullopt;
    const Vec2 gravity = world.model().gravity.value_or(Vec2{});
    // A ball that a hand has hit may have been stopped again within the tick.
    double thrown = 0.0;
    for (const Hand& hand : world.hands().each)
        thrown = std::max(thrown, 2.0 * hand.pace);
    const std::vector<double> within = fastest_within(world, contacts, ids_, velocity_);
    std::size_t before = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        while (before < ids_.size() && ids_[before] < balls.id[i])
            ++before;
        if (before == ids_.size()) break;
        if (ids_[before] != balls.id[i] || is_held(world, balls.id[i])) continue;
        const Vec2 from = position_[before];
        const Vec2 to = balls.position[i];
        const double fastest = std::max({thrown, within[before], length(balls.velocity[i])}) +
                               length(gravity) * world.tick_length();
        const double way = 2.0 * fastest * world.tick_length();
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const Capsule& edge = edges.shape[e];
            if (!are_on_two_sides(from, to, edge.start, edge.end) ||
                !are_on_two_sides(edge.start, edge.end, from, to) ||
                !is_wall(world, e, balls.kind[i]) ||
                is_exempt({number(balls.id[i]), edge_mark + number(edges.id[e])}))
                continue;
            const double detour = std::min(length(from - edge.start) + length(to - edge.start),
                                           length(from - edge.end) + length(to - edge.end));
            if (detour <= way) continue;
            return Breach{.kind = Breach::Kind::side,
                          .tick = world.tick(),
                          .ball = balls.id[i],
                          .edge = edges.id[e],
                          .amount = distance_to_segment(to, edge)};
        }
    }
    return std::nullopt;
}

bool InvariantCheck::is_exempt(const Pair& pair) const {
    return std::ranges::binary_search(exempt_, pair);
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
            visit(Pair{number(balls.id[i]), edge_mark + number(edges.id[e])}, depth,
                  balls.radius[i], Breach{.ball = balls.id[i], .edge = edges.id[e]});
        }
    }
}

std::optional<Breach> InvariantCheck::check_overlap(const World& world) {
    std::optional<Breach> deepest;
    std::vector<Pair> still_deep;
    // The solver itself names these balls, and those for which time stood still. All others
    // are held to what exact trajectories promise.
    const std::vector<BallId>& clustered = event_memory(world).clustered;
    const auto is_clustered = [&](const Breach& pair) {
        const auto is_in = [&](BallId ball) { return std::ranges::binary_search(clustered, ball); };
        return pair.ball && is_in(*pair.ball) && (!pair.other || is_in(*pair.other));
    };
    const auto is_new = [&](BallId ball) { return !std::ranges::binary_search(ids_, ball); };
    for_each_overlap(world, [&](const Pair& pair, double depth, double radius, Breach breach) {
        if (!(depth > promise_.parted * radius)) return;
        if (is_exempt(pair) || is_new(*breach.ball) || (breach.other && is_new(*breach.other))) {
            still_deep.push_back(pair);
            return;
        }
        const double most =
            is_clustered(breach) ? promise_.overlap_of_clustered : *promise_.overlap;
        if (!(depth > most * radius)) return;
        if (deepest && depth <= deepest->amount) return;
        breach.kind = Breach::Kind::overlap;
        breach.tick = world.tick();
        breach.amount = depth;
        deepest = breach;
    });
    std::ranges::sort(still_deep);
    exempt_ = std::move(still_deep);
    return deepest;
}

std::optional<Breach> InvariantCheck::check_time(const World& world, bool stood_still) const {
    if (world.tick() != tick_ + 1)
        return Breach{.kind = Breach::Kind::time, .tick = world.tick(), .amount = 0.0};
    if (!promise_.moves || stood_still || ids_ != world.balls().id || world.model().wrap)
        return std::nullopt;
    return find_ball_that_stays(world, promise_, position_, velocity_);
}

}  // namespace carom
