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

// How far balls go in a tick, in their own radii: of those that go far.
std::vector<double> far_paths(const World& world) {
    const Balls& balls = world.balls();
    const Model& model = world.model();
    const double tick = world.tick_length();
    const double fall = model.gravity ? length(*model.gravity) * tick : 0.0;
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
    if (std::ssize(world.balls().velocity) <= swept_tolerance::most_far_balls) return plain;
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
