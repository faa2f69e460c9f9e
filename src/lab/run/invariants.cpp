#include "lab/run/invariants.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lab/run/fastest_within.h"
#include "lab/run/time_check.h"
#include "lab/run/walls.h"

namespace carom {
namespace {

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

bool are_on_two_sides(Vec2 a, Vec2 b, Vec2 start, Vec2 end) {
    const double first = cross(end - start, a - start);
    const double second = cross(end - start, b - start);
    return (first > 0.0 && second < 0.0) || (first < 0.0 && second > 0.0);
}

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
                is_exempt(pair_with_edge(balls.id[i], edges.id[e])))
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

std::optional<Breach> InvariantCheck::check_time(const World& world, bool stood_still) const {
    if (world.tick() != tick_ + 1)
        return Breach{.kind = Breach::Kind::time, .tick = world.tick(), .amount = 0.0};
    if (!promise_.moves || stood_still || ids_ != world.balls().id || world.model().wrap)
        return std::nullopt;
    return find_ball_that_stays(world, promise_, position_, velocity_);
}

}  // namespace carom
