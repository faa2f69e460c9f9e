#include "game/ai/pinball_sight.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "game/pinball/pinball.h"
#include "game/pinball/pinball_table.h"
#include "geometry/closest.h"

namespace carom {
namespace {

// In radii. Inlanes and outlanes begin within these distances from the pivots; the lane of the
// plunger is farther away.
constexpr double reach_above = 22.0;
constexpr double reach_beside = 12.0;

constexpr double touching = 0.25;      // radii between a flipper and a ball that lies on it
constexpr double farthest_rest = 0.8;  // along a flipper: beyond it a ball rolls off

// What the places of a ball are worth.
constexpr double lost = -100.0;
constexpr double held = 50.0;
constexpr double held_by_hole = 14.0;
constexpr double rolling_in = 25.0;  // slowly, near the flippers
constexpr double at_play = 12.0;
constexpr double falling_in = 5.0;
constexpr double slow = 60.0;  // radii a second

// What goals are worth, in points.
constexpr double lit = 400.0;
constexpr double extra_ball = 20'000.0;
constexpr double another_ball = 5'000.0;
constexpr double share_of_bonus = 0.3;

bool has_cradle(const Flipper& flipper) {
    return std::fabs(flipper.rest.x) > std::fabs(flipper.rest.y) &&
           cross(flipper.rest, Vec2{0.0, 1.0}) * flipper.sweep > 0.0;
}

}  // namespace

PinballSight::PinballSight(const Scene& scene) : scene_(&scene) {
    const World& world = scene.world;
    if (world.balls().size() > 0) radius_ = world.balls().radius[0];
    std::vector<std::pair<Vec2, std::size_t>> pivots;
    for (std::size_t i = 0; i < world.flippers().size(); ++i)
        if (const auto capsule = index_of(world, world.flippers()[i].capsule))
            pivots.emplace_back(world.capsules().shape[*capsule].start, i);
    if (pivots.size() < 2) return;
    std::ranges::stable_sort(pivots, {}, [](const auto& pivot) { return pivot.first.y; });
    if (pivots[0].first.x > pivots[1].first.x) std::swap(pivots[0], pivots[1]);
    has_pair_ = true;
    left_ = pivots[0].second;
    right_ = pivots[1].second;
    left_pivot_ = pivots[0].first;
    right_pivot_ = pivots[1].first;
    const auto tip = [&](std::size_t i, Vec2 pivot) {
        return flipper_end(world.flippers()[i], pivot, 0.0).y;
    };
    tips_ = std::min(tip(left_, left_pivot_), tip(right_, right_pivot_));
}

bool PinballSight::is_near(const World& world, std::size_t ball) const {
    const Vec2 at = world.balls().position[ball];
    return world.kinds()[world.balls().kind[ball]].layer == 0 &&
           at.y < std::max(left_pivot_.y, right_pivot_.y) + reach_above * radius_ &&
           at.x > left_pivot_.x - reach_beside * radius_ &&
           at.x < right_pivot_.x + reach_beside * radius_;
}

bool PinballSight::is_lost(const World& world, std::size_t ball) const {
    const Vec2 at = world.balls().position[ball];
    if (!is_near(world, ball)) return false;
    if (at.y < tips_ - radius_) return true;
    return at.y < std::min(left_pivot_.y, right_pivot_.y) && is_outside_pivots(at);
}

bool PinballSight::is_beside(const World& world, std::size_t ball) const {
    return is_near(world, ball) && !is_lost(world, ball) &&
           is_outside_pivots(world.balls().position[ball]);
}

bool PinballSight::is_outside_pivots(Vec2 at) const {
    return at.x < left_pivot_.x - radius_ || at.x > right_pivot_.x + radius_;
}

std::optional<std::size_t> PinballSight::cradle_of(const World& world, std::size_t ball,
                                                   double speed) const {
    if (length(world.balls().velocity[ball]) > speed * radius_) return std::nullopt;
    const Disc disc{world.balls().position[ball], world.balls().radius[ball]};
    for (std::size_t i = 0; i < world.flippers().size(); ++i) {
        const Flipper& flipper = world.flippers()[i];
        const auto capsule = index_of(world, flipper.capsule);
        if (!capsule || !flipper.is_pressed || flipper.progress < 0.9 || !has_cradle(flipper))
            continue;
        const Capsule& shape = world.capsules().shape[*capsule];
        const Vec2 along = shape.end - shape.start;
        if (dot(disc.center - shape.start, along) > farthest_rest * dot(along, along)) continue;
        if (separation(disc, shape) < touching * radius_) return i;
    }
    return std::nullopt;
}

Button PinballSight::button_for(const World& world, std::size_t ball) const {
    const double middle = 0.5 * (left_pivot_.x + right_pivot_.x);
    return button_of(world.balls().position[ball].x < middle ? left_ : right_);
}

double PinballSight::worth(const PinballState& state) const {
    const auto points = static_cast<double>(state.score);
    const auto bonus = static_cast<double>(state.bonus * state.multiplier * scene_->table.bonus);
    return points + share_of_bonus * bonus +
           lit * static_cast<double>(std::ranges::count(state.is_lit, 1)) +
           extra_ball * static_cast<double>(state.extra_balls) +
           another_ball * static_cast<double>(state.to_serve);
}

double PinballSight::safety_of(const World& world, const PinballState& state,
                               std::size_t ball) const {
    if (is_held(state, world.balls().id[ball])) return held_by_hole;
    if (is_lost(world, ball)) return lost;
    if (!is_near(world, ball)) return at_play;
    const double speed = length(world.balls().velocity[ball]) / radius_;
    if (cradle_of(world, ball, slow)) return held - 0.4 * speed;
    if (speed < slow) return rolling_in - 0.2 * speed;
    return world.balls().velocity[ball].y > 0.0 ? at_play : falling_in;
}

double PinballSight::safety(const World& world, const PinballState& state) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < world.balls().size(); ++i)
        if (is_in_play(*scene_, state, world.balls().id[i])) sum += safety_of(world, state, i);
    return sum;
}

}  // namespace carom
