#include <algorithm>
#include <cmath>

#include "geometry/closest.h"
#include "physics/discrete/solver.h"
#include "physics/laws/bounce.h"
#include "physics/world/solver_access.h"

// How the solvers `discrete` and `substep` separate bodies that overlap once all have moved.
namespace carom {
namespace {

// Marks a ball that was pushed beyond the place for which its edges are known.
constexpr std::uint8_t escaped = 2;

template <Terms terms>
bool overlap(const World& world, const BallPair& pair) {
    const Balls& balls = world.balls();
    Vec2 offset = balls.position[pair.first] - balls.position[pair.second];
    if (terms.wrap()) offset = nearest_image(offset, size(*world.model().wrap));
    const double reach = balls.radius[pair.first] + balls.radius[pair.second];
    return length_squared(offset) < reach * reach;
}

}  // namespace

void OverlapSolver::separate_bodies(World& world) {
    with_terms(terms_of(world), [&]<Terms terms>() {
        if (is_first_step_)
            separate_overlapping<terms>(world, neighbours_.pairs());
        else
            separate_active<terms>(world);
        push_out_of_edges<terms>(world);
    });
}

// The displacement of a ball that has moved in this step and has not been pushed yet.
Vec2 OverlapSolver::displacement_of(const World& world, std::uint32_t ball) const {
    if (keeps_displacements_) return displacement_[ball];
    return world.balls().velocity[ball] * (is_first_step_ ? duration_ : left_[ball]) + Vec2{};
}

// The ball is about to be pushed, perhaps not for the first time in this step.
void OverlapSolver::note_push(const World& world, std::uint32_t ball) {
    if (is_pushed_[ball]) return;
    is_pushed_[ball] = 1;
    const Vec2 position = world.balls().position[ball];
    if (keeps_time_ && (is_first_step_ || is_active_[ball])) {
        const Vec2 way = displacement_of(world, ball);
        pushed_.push_back({ball, length(way), position - way});
    } else {
        pushed_.push_back({ball, 0.0, position});
    }
}

template <Terms terms>
void OverlapSolver::separate_active(World& world) {
    neighbours_.list_by_ball();
    near_active_.clear();
    for (const std::uint32_t i : active_)
        for (const std::uint32_t j : neighbours_.of(i))
            if (j > i || !is_active_[j]) near_active_.push_back({i, j});
    separate_overlapping<terms>(world, near_active_);
}

// Whether the two would overlap if they were as large as the largest ball.
template <Terms terms>
bool OverlapSolver::are_near(const World& world, const BallPair& pair) const {
    Vec2 offset = world.balls().position[pair.first] - world.balls().position[pair.second];
    if (terms.wrap()) offset = nearest_image(offset, size(*world.model().wrap));
    return length_squared(offset) < widest_ * widest_;
}

// Which of the pairs overlap is decided before any is separated.
template <Terms terms>
void OverlapSolver::separate_overlapping(World& world, std::span<const BallPair> pairs) {
    overlapping_.clear();
    for (const BallPair& pair : pairs)
        if (are_near<terms>(world, pair)) overlapping_.push_back(pair);
    if (!are_alike_)
        std::erase_if(overlapping_,
                      [&](const BallPair& pair) { return !overlap<terms>(world, pair); });
    order_.sort(overlapping_, world.balls().size());
    for (const BallPair& pair : overlapping_)
        separate<terms>(world, pair.first, pair.second);
}

// The pair overlapped when all had moved. Other pairs may have separated it since.
template <Terms terms>
void OverlapSolver::separate(World& world, std::uint32_t i, std::uint32_t j) {
    Balls& balls = SolverAccess(world).balls();
    Vec2 offset = balls.position[i] - balls.position[j];
    if (terms.wrap()) offset = nearest_image(offset, size(*world.model().wrap));
    const double reach = balls.radius[i] + balls.radius[j];
    const double squared = length_squared(offset);
    if (squared >= reach * reach) return;
    if (terms.special() && !kinds_meet(world, balls.kind[i], balls.kind[j])) return;
    note_push(world, i);
    note_push(world, j);
    const Vec2 normal = direction(offset, when_coincident);
    double share_i = 0.5;
    double share_j = 0.5;
    if (terms.special()) {
        const bool i_held = inverse_mass_[i] == 0.0;
        const bool j_held = inverse_mass_[j] == 0.0;
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

// Balls that moved are checked: in the first step all, later the active ones, and in every step
// those that were pushed. The neighbour list has the edges of all balls that did not.
template <Terms terms>
void OverlapSolver::push_out_of_edges(World& world) {
    if (!world.model().ball_edge) return;
    at_edge_.clear();
    const auto note = [&](const EdgePair& pair) {
        const Disc disc{world.balls().position[pair.ball], world.balls().radius[pair.ball]};
        if (overlaps_edge(world, pair, disc)) at_edge_.push_back(pair);
    };
    for (const Pushed& pushed : pushed_) {
        if (knows_edges(world, pushed)) continue;
        is_pushed_[pushed.ball] = escaped;
        neighbours_.for_each_edge_at(pushed.ball, world.balls().position[pushed.ball], note);
    }
    if (is_first_step_) {
        for (const EdgePair& pair : neighbours_.edges())
            if (is_pushed_[pair.ball] != escaped) note(pair);
    } else {
        const auto look = [&](std::uint32_t ball) {
            if (is_pushed_[ball] != escaped)
                for (const EdgePair& pair : neighbours_.edges_of(ball))
                    note(pair);
        };
        for (const std::uint32_t i : active_)
            look(i);
        for (const Pushed& pushed : pushed_)
            if (!is_active_[pushed.ball]) look(pushed.ball);
    }
    if (terms.special())
        for (const HeldCapsule& held : world.held_capsules())
            if (const auto index = index_of(world, held.id))
                for (std::uint32_t i = 0; i < world.balls().size(); ++i)
                    if (is_first_step_ || is_active_[i] || is_pushed_[i])
                        note({i, static_cast<std::uint32_t>(*index)});
    std::sort(at_edge_.begin(), at_edge_.end());
    for (const EdgePair& pair : at_edge_)
        push_out_of_edge<terms>(world, pair);
}

// Whether the neighbour list has all edges that the ball may touch where it is now.
bool OverlapSolver::knows_edges(const World& world, const Pushed& pushed) const {
    const Vec2 position = world.balls().position[pushed.ball];
    if (margin_ > 0.0) return neighbours_.covers(pushed.ball, position);
    Vec2 way = position - pushed.origin;
    if (world.model().wrap) way = nearest_image(way, size(*world.model().wrap));
    const double margin = 0.999 * neighbours_.edge_margin(world.balls().radius[pushed.ball]);
    return length_squared(way) <= margin * margin;
}

template <Terms terms>
void OverlapSolver::push_out_of_edge(World& world, const EdgePair& pair) {
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
    const Vec2 across = direction(perpendicular(shape.end - shape.start), when_coincident);
    const Vec2 normal =
        direction(offset, dot(across, balls.velocity[ball]) > 0.0 ? -across : across);
    position += normal * (reach - std::sqrt(squared));
    pairs_.push_back({ball, capsule, ContactKind::ball_edge, shift});
}

}  // namespace carom
