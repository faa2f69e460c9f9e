#include "physics/discrete/separation.h"

#include <algorithm>
#include <cmath>

#include "geometry/closest.h"
#include "physics/laws/bounce.h"
#include "physics/world/solver_access.h"

namespace carom {
namespace {

// Marks a ball that was pushed beyond the place for which its edges are known.
constexpr std::uint8_t beyond_margin = 2;

template <Terms terms>
Vec2 offset_of(const World& world, const BallPair& pair) {
    const Vec2 offset = world.balls().position[pair.first] - world.balls().position[pair.second];
    return terms.wrap() ? nearest_image(offset, size(*world.model().wrap)) : offset;
}

template <Terms terms>
bool overlap(const World& world, const BallPair& pair) {
    const double reach = world.balls().radius[pair.first] + world.balls().radius[pair.second];
    return length_squared(offset_of<terms>(world, pair)) < reach * reach;
}

}  // namespace

void OverlapSeparation::separate(World& world) {
    with_terms(step_.terms, [&]<Terms terms>() {
        if (step_.is_first)
            separate_overlapping<terms>(world, neighbours_.list().pairs());
        else
            separate_active<terms>(world);
        push_out_of_edges<terms>(world);
    });
}

// The ball is about to be pushed, perhaps not for the first time in this step.
void OverlapSeparation::note_push(const World& world, std::uint32_t ball) {
    if (is_pushed_[ball]) return;
    is_pushed_[ball] = 1;
    const Vec2 position = world.balls().position[ball];
    if (step_.has_several && (step_.is_first || motion_.is_active(ball))) {
        const Vec2 displacement = motion_.displacement_of(world, ball);
        pushed_.push_back({ball, length(displacement), position - displacement});
    } else {
        pushed_.push_back({ball, 0.0, position});
    }
}

template <Terms terms>
void OverlapSeparation::separate_active(World& world) {
    NeighbourList& list = neighbours_.list();
    list.list_by_ball();
    near_active_.clear();
    for (const std::uint32_t i : motion_.active())
        for (const std::uint32_t j : list.of(i))
            if (j > i || !motion_.is_active(j)) near_active_.push_back({i, j});
    separate_overlapping<terms>(world, near_active_);
}

// Which of the pairs overlap is decided before any is separated: first as if all balls were as
// large as the largest one, which needs no radii.
template <Terms terms>
void OverlapSeparation::separate_overlapping(World& world, std::span<const BallPair> pairs) {
    overlapping_.clear();
    const double widest = neighbours_.widest();
    for (const BallPair& pair : pairs)
        if (length_squared(offset_of<terms>(world, pair)) < widest * widest)
            overlapping_.push_back(pair);
    if (!neighbours_.are_alike())
        std::erase_if(overlapping_,
                      [&](const BallPair& pair) { return !overlap<terms>(world, pair); });
    order_.sort(overlapping_, world.balls().size());
    for (const BallPair& pair : overlapping_)
        separate_pair<terms>(world, pair.first, pair.second);
}

// The pair overlapped when all had moved. Other pairs may have separated it since.
template <Terms terms>
void OverlapSeparation::separate_pair(World& world, std::uint32_t i, std::uint32_t j) {
    Balls& balls = SolverAccess(world).balls();
    const Vec2 offset = offset_of<terms>(world, {i, j});
    const double reach = balls.radius[i] + balls.radius[j];
    const double squared = length_squared(offset);
    if (squared >= reach * reach) return;
    if (terms.special() && !kinds_meet(world, balls.kind[i], balls.kind[j])) return;
    note_push(world, i);
    note_push(world, j);
    const Vec2 normal = direction(offset, normal_when_coincident);
    double share_i = 0.5;
    double share_j = 0.5;
    if (terms.special()) {
        const bool i_held = kinematics_.is_held(i);
        const bool j_held = kinematics_.is_held(j);
        if (i_held != j_held) {
            share_i = i_held ? 0.0 : 1.0;
            share_j = j_held ? 0.0 : 1.0;
        }
    }
    const double depth = reach - std::sqrt(squared);
    balls.position[i] += normal * (depth * share_i);
    balls.position[j] -= normal * (depth * share_j);
    if (terms.wrap()) {
        balls.position[i] = wrapped(balls.position[i], *world.model().wrap);
        balls.position[j] = wrapped(balls.position[j], *world.model().wrap);
    }
    pairs_.push_back({i, j, ContactKind::ball_ball, {}});
}

template <Terms terms>
void OverlapSeparation::push_out_of_edges(World& world) {
    if (!world.model().ball_edge) return;
    at_edge_.clear();
    find_edges_of_moved_balls(world);
    if (terms.special()) find_kinematic_edges(world);
    std::sort(at_edge_.begin(), at_edge_.end());
    for (const EdgePair& pair : at_edge_)
        push_out_of_edge<terms>(world, pair);
}

inline void OverlapSeparation::note_edge(const World& world, const EdgePair& pair) {
    const Disc disc{world.balls().position[pair.ball], world.balls().radius[pair.ball]};
    if (overlaps_edge(world, pair, disc)) at_edge_.push_back(pair);
}

// Balls that moved are checked: in the first step all, later the active ones, and in every step
// those that were pushed. The neighbour list has the edges of all balls that are within its margin;
// for the others the cells are asked.
void OverlapSeparation::find_edges_of_moved_balls(const World& world) {
    const NeighbourList& list = neighbours_.list();
    for (const PushedBall& pushed : pushed_) {
        if (neighbours_.has_edges_of(world, pushed)) continue;
        is_pushed_[pushed.ball] = beyond_margin;
        list.for_each_edge_at(pushed.ball, world.balls().position[pushed.ball],
                              [&](const EdgePair& pair) { note_edge(world, pair); });
    }
    if (step_.is_first) {
        for (const EdgePair& pair : list.edges())
            if (is_pushed_[pair.ball] != beyond_margin) note_edge(world, pair);
        return;
    }
    const auto note_edges_of = [&](std::uint32_t ball) {
        if (is_pushed_[ball] == beyond_margin) return;
        for (const EdgePair& pair : list.edges_of(ball))
            note_edge(world, pair);
    };
    for (const std::uint32_t i : motion_.active())
        note_edges_of(i);
    for (const PushedBall& pushed : pushed_)
        if (!motion_.is_active(pushed.ball)) note_edges_of(pushed.ball);
}

// The list leaves them out.
void OverlapSeparation::find_kinematic_edges(const World& world) {
    for (const HeldCapsule& held : world.held_capsules()) {
        const auto index = index_of(world, held.id);
        if (!index) continue;
        for (std::uint32_t i = 0; i < world.balls().size(); ++i)
            if (step_.is_first || motion_.is_active(i) || is_pushed_[i])
                note_edge(world, {i, static_cast<std::uint32_t>(*index)});
    }
}

template <Terms terms>
void OverlapSeparation::push_out_of_edge(World& world, const EdgePair& pair) {
    const std::uint32_t ball = pair.ball;
    const std::uint32_t capsule = pair.capsule;
    Balls& balls = SolverAccess(world).balls();
    Capsule shape = world.capsules().shape[capsule];
    Vec2 shift;
    if (terms.wrap()) {
        const Vec2 torus = size(*world.model().wrap);
        shift = {pair.across * torus.x, pair.along * torus.y};
        shape.start += shift;
        shape.end += shift;
    }
    Vec2& position = balls.position[ball];
    const Vec2 offset = position - closest_point(shape.start, shape.end, position);
    const double reach = balls.radius[ball] + shape.radius;
    const double squared = length_squared(offset);
    if (squared >= reach * reach) return;
    if (terms.special() &&
        !kind_meets_material(world, balls.kind[ball], world.capsules().material[capsule]))
        return;
    if (terms.special() && world.model().one_way &&
        (!is_on_solid_side(shape, world.capsules().side[capsule], position) ||
         dot(balls.velocity[ball], offset) > 0.0))
        return;
    note_push(world, ball);
    const Vec2 across = direction(perpendicular(shape.end - shape.start), normal_when_coincident);
    const Vec2 normal =
        direction(offset, dot(across, balls.velocity[ball]) > 0.0 ? -across : across);
    position += normal * (reach - std::sqrt(squared));
    pairs_.push_back({ball, capsule, ContactKind::ball_edge, shift});
}

void OverlapSeparation::end_step() {
    for (const PushedBall& pushed : pushed_)
        is_pushed_[pushed.ball] = 0;
    pushed_.clear();
    pairs_.clear();
}

}  // namespace carom
