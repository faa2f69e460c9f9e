#include "physics/world/mover.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "physics/world/world.h"

namespace carom {
namespace {

// A clock this close to a stop, as a share of the time from stop to stop, stands there.
constexpr double clock_rounding = 1e-9;

double progress_at(const Mover& mover, double clock) {
    const double share = clock / mover.period;
    if (mover.is_round) return share;
    if (mover.is_steady) return share <= 0.5 ? 2.0 * share : 2.0 - 2.0 * share;
    return 0.5 - 0.5 * sin_cos(2.0 * pi * share).cos;
}

Vec2 place_on(const std::vector<Vec2>& path, double progress) {
    double whole = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i)
        whole += distance(path[i - 1], path[i]);
    double left = progress * whole;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const double leg = distance(path[i - 1], path[i]);
        if (left <= leg && leg > 0.0) return path[i - 1] + (path[i] - path[i - 1]) * (left / leg);
        left -= leg;
    }
    return path.back();
}

}  // namespace

MoverClock clock_after(const Mover& mover, double duration) {
    const double clock = mover.clock + duration;
    if (mover.stops > 0) {
        const double between = mover.period / mover.stops;
        const double next = std::floor(mover.clock / between + clock_rounding) + 1.0;
        if (clock >= between * (next - clock_rounding))
            return {next < mover.stops ? between * next : 0.0, false};
    }
    return {clock < mover.period ? clock : clock - mover.period, true};
}

Capsule mover_shape(const Mover& mover, const MovedEdge& edge, double clock) {
    Capsule shape = edge.home;
    const double progress = progress_at(mover, clock);
    if (mover.angle != 0.0) {
        const auto [sine, cosine] = sin_cos(mover.angle * progress);
        for (Vec2* const end : {&shape.start, &shape.end}) {
            const Vec2 arm = *end - mover.pivot;
            *end = mover.pivot + arm * cosine + perpendicular(arm) * sine;
        }
    }
    if (!mover.path.empty()) {
        const Vec2 shift = place_on(mover.path, progress);
        shape.start += shift;
        shape.end += shift;
    }
    return shape;
}

bool is_moved_by_mover(const World& world, CapsuleId id) {
    return std::ranges::any_of(world.movers(), [id](const Mover& mover) {
        return std::ranges::binary_search(mover.edges, id, {}, &MovedEdge::capsule);
    });
}

bool moves_by_itself(const World& world, CapsuleId id) {
    return is_moved_by_mover(world, id) || seesaw_of(world, id);
}

}  // namespace carom
