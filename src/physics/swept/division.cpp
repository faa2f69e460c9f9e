#include "physics/swept/division.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <vector>

#include "physics/swept/tolerances.h"

namespace carom {
namespace {

// What gravity adds to a speed in a tick.
double fall_speed(const World& world) {
    return world.model().gravity ? length(*world.model().gravity) * world.tick_length() : 0.0;
}

// Whether more than `most_far_balls` balls could go far: a bound without roots, since nearly every
// tick ends here. It uses (a + b)^2 <= 2 (a^2 + b^2).
bool can_many_go_far(const World& world) {
    const Balls& balls = world.balls();
    const double fall = fall_speed(world);
    const double radii = world.tick_length() / swept_tolerance::far;
    const double scale = 2.0 * radii * radii;
    std::ptrdiff_t count = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const double radius = balls.radius[i];
        const double bound = (length_squared(balls.velocity[i]) + fall * fall) * scale;
        count += bound < radius * radius ? 0 : 1;
    }
    return count > swept_tolerance::most_far_balls;
}

// How far balls go in a tick, in their own radii: of those that go far.
std::vector<double> far_paths(const World& world) {
    const Balls& balls = world.balls();
    const Model& model = world.model();
    const double tick = world.tick_length();
    const double fall = fall_speed(world);
    const double most = model.speed_limit.value_or(std::numeric_limits<double>::infinity());
    std::vector<double> paths;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const double path = (std::min(length(balls.velocity[i]), most) + fall) * tick;
        if (is_far(path, balls.radius[i])) paths.push_back(path / balls.radius[i]);
    }
    return paths;
}

}  // namespace

bool is_far(double path, double radius) {
    return path > swept_tolerance::far * radius;
}

SweptDivision divide_tick(const World& world, int asked) {
    const double tick = world.tick_length();
    const SweptDivision plain{asked, tick / asked};
    if (!can_many_go_far(world)) return plain;
    std::vector<double> paths = far_paths(world);
    if (std::ssize(paths) <= swept_tolerance::most_far_balls) return plain;
    const auto last = paths.begin() + swept_tolerance::most_far_balls;
    std::nth_element(paths.begin(), last, paths.end(), std::greater{});
    const double needed = std::ceil(*last / swept_tolerance::short_path);
    if (!(*last > swept_tolerance::far * asked)) return plain;
    constexpr int most = swept_tolerance::most_substeps;
    if (needed <= most) return {static_cast<int>(needed), tick / needed};
    return {most, tick / needed, tick - tick / needed * most};
}

}  // namespace carom
