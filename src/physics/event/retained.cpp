#include <algorithm>
#include <array>
#include <cmath>

#include "physics/event/motion/edge_impact.h"
#include "physics/event/motion/stored_trajectory.h"
#include "physics/event/motion/tolerances.h"
#include "physics/event/world_sync.h"

// Which trajectories that were stored still hold when a tick rebuilds.
namespace carom {

// Whether the trajectory leads through the state that the world shows now.
template <typename Real>
bool WorldSync<Real>::leads_through(const Trajectory<Real>& trajectory, std::size_t ball) const {
    if (trajectory.motion == Motion::held || trajectory.time > scene_.now) return false;
    if (trajectory.motion == Motion::turning && piece_end(trajectory, scene_.field) < scene_.now)
        return false;
    if (!cloth_.is_of_this_cloth(trajectory)) return false;
    const BallState<Real> state = state_at(trajectory, scene_.field, scene_.now);
    return trajectories_.shown_position(trajectory, scene_.now) ==
               scene_.world->balls().position[ball] &&
           Vec2(state.velocity) == scene_.world->balls().velocity[ball] &&
           is_rotation_unchanged(static_cast<std::uint32_t>(ball));
}

// Whether the edges that support the ball are still there, as they were.
template <typename Real>
bool WorldSync<Real>::are_supports_unchanged(const Trajectory<Real>& trajectory,
                                             std::uint32_t digest) const {
    return trajectory.motion == Motion::free ||
           digest_of_supports(*scene_.world, trajectory.support, trajectory.second_support) ==
               digest;
}

// Whether the balls that support the ball are still there.
template <typename Real>
bool WorldSync<Real>::has_support(std::size_t ball) const {
    const Trajectory<Real> trajectory = balls_.trajectory(ball);
    for (const SupportId& support : {trajectory.support, trajectory.second_support}) {
        if (support.kind != SupportId::Kind::ball) continue;
        const auto index = index_of(*scene_.world, BallId{support.number});
        // A ball that rests is where it was.
        if (!index || !is_kept_[*index] || balls_[*index].line.motion != Motion::resting)
            return false;
    }
    return true;
}

// Whether an impact with an edge lies in the trajectory's past: an edge that was put there since.
// When that shows must not depend on where a solver looks for edges, so all edges are tested that
// the ball can have reached by its speed and largest acceleration.
template <typename Real>
bool WorldSync<Real>::has_passed_an_edge(std::uint32_t ball) {
    const Trajectory<Real> trajectory = balls_.trajectory(ball);
    const bool stays = trajectory.motion == Motion::held || trajectory.motion == Motion::resting ||
                       trajectory.motion == Motion::still;
    if (!scene_.world->model().ball_edge || stays || !(trajectory.time < scene_.now)) return false;
    const auto since = static_cast<double>(scene_.now - trajectory.time);
    const auto pull =
        static_cast<double>(most_acceleration(trajectory, scene_.field, trajectory.time));
    const Vec2 begin(trajectory.position);
    const double furthest = (length(Vec2(trajectory.velocity)) + 0.5 * pull * since) * since;
    search_.begin_at(scene_.now);
    const bool wraps = scene_.world->model().wrap.has_value();
    // Too far to check: the trajectory starts anew.
    if (wraps && !(furthest < most_checked_periods * std::min(scene_.period.x, scene_.period.y)))
        return true;
    // The first and last periodic image of an edge that lies within reach.
    const auto images = [wraps](double at, double low, double high, double reach, double period) {
        if (!wraps) return std::array<int, 2>{0, 0};
        return std::array<int, 2>{static_cast<int>(std::floor((at - reach - high) / period)) + 1,
                                  static_cast<int>(std::ceil((at + reach - low) / period)) - 1};
    };
    const Capsules& capsules = scene_.world->capsules();
    for (std::uint32_t i = 0; i < capsules.size(); ++i) {
        if (is_held(*scene_.world, capsules.id[i]) || !scene_.ball_collides_with(ball, i)) continue;
        const Capsule& shape = capsules.shape[i];
        const double reach =
            1.01 * (furthest + static_cast<double>(balls_.radius(ball)) + shape.radius);
        const auto [left, right] = std::minmax(shape.start.x, shape.end.x);
        const auto [low, high] = std::minmax(shape.start.y, shape.end.y);
        if (!wraps && (begin.x + reach < left || begin.x - reach > right || begin.y + reach < low ||
                       begin.y - reach > high))
            continue;
        const auto [first_across, last_across] =
            images(begin.x, left, right, reach, scene_.period.x);
        const auto [first_along, last_along] = images(begin.y, low, high, reach, scene_.period.y);
        for (int across = first_across; across <= last_across; ++across)
            for (int along = first_along; along <= last_along; ++along) {
                if (scene_.is_supported_by(trajectory, i, across, along)) continue;
                const Vec2 shift{scene_.period.x * across, scene_.period.y * along};
                const auto time =
                    edge_time_of_impact(trajectory, Edge<Real>(shape, shift), balls_.radius(ball),
                                        scene_.field, scene_.now, search_);
                if (time && *time < scene_.now &&
                    scene_.is_solid(i, state_at(trajectory, scene_.field, *time).position, shift))
                    return true;
            }
    }
    return false;
}

template bool WorldSync<double>::leads_through(const Trajectory<double>&, std::size_t) const;
template bool WorldSync<DoubleDouble>::leads_through(const Trajectory<DoubleDouble>&,
                                                     std::size_t) const;
template bool WorldSync<double>::are_supports_unchanged(const Trajectory<double>&,
                                                        std::uint32_t) const;
template bool WorldSync<DoubleDouble>::are_supports_unchanged(const Trajectory<DoubleDouble>&,
                                                              std::uint32_t) const;
template bool WorldSync<double>::has_support(std::size_t) const;
template bool WorldSync<DoubleDouble>::has_support(std::size_t) const;
template bool WorldSync<double>::has_passed_an_edge(std::uint32_t);
template bool WorldSync<DoubleDouble>::has_passed_an_edge(std::uint32_t);

}  // namespace carom
