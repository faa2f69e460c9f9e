#include <algorithm>
#include <array>
#include <cmath>

#include "physics/event/engine.h"

// Which of the paths that the world remembers, or for other numbers this engine, still hold when a
// tick begins anew.
namespace carom {

template <typename Real>
bool EventEngine<Real>::leads_through(const EventPath<Real>& path, std::size_t ball) const {
    if (path.motion == Motion::held || path.time > now_) return false;
    if (path.motion == Motion::turning && piece_end(path, field_) < now_) return false;
    if (!is_path_on_cloth(path)) return false;
    const BallState<Real> state = state_at(path, field_, now_);
    return shown_position(path, now_) == world_->balls.position[ball] &&
           Vec2(state.velocity) == world_->balls.velocity[ball] &&
           is_turn_left(static_cast<std::uint32_t>(ball));
}

// Whether the edges that carry the ball are still there, as they were.
template <typename Real>
bool EventEngine<Real>::are_carriers_left(const EventPath<Real>& path, std::uint32_t sum) const {
    return path.motion == Motion::free ||
           sum_of_carriers(*world_, path.support, path.second_support) == sum;
}

// Whether the balls that carry the ball are still there.
template <typename Real>
bool EventEngine<Real>::has_support(const std::vector<std::uint8_t>& is_kept,
                                    std::size_t ball) const {
    const EventPath<Real> path = balls_.path(ball);
    for (const PathSupport& support : {path.support, path.second_support}) {
        if (support.by != PathSupport::By::ball) continue;
        const auto index = index_of(*world_, BallId{support.number});
        // It rests, so it is where it was.
        if (!index || !is_kept[*index] || balls_[*index].line.motion != Motion::resting)
            return false;
    }
    return true;
}

// Whether the path has met an edge before now: one that has come into its way only since. When that
// shows must not depend on where a solver looks for edges. No ball is further from where its path
// began than its speed and the largest acceleration allow.
template <typename Real>
bool EventEngine<Real>::has_passed_an_edge(std::uint32_t ball) {
    const EventPath<Real> path = balls_.path(ball);
    const bool stays = path.motion == Motion::held || path.motion == Motion::resting ||
                       path.motion == Motion::still;
    if (!world_->model.ball_edge || stays || !(path.time < now_)) return false;
    const auto since = static_cast<double>(now_ - path.time);
    const auto pull = static_cast<double>(most_acceleration(path, field_, path.time));
    const Vec2 begin(path.position);
    const double way = (length(Vec2(path.velocity)) + 0.5 * pull * since) * since;
    search_.begin_at(now_);
    const bool wraps = world_->model.wrap.has_value();
    // Too long a way to be gone through for this: the path may begin anew.
    constexpr double most_tori = 4.0;
    if (wraps && !(way < most_tori * std::min(torus_.x, torus_.y))) return true;
    // From where to where images of an edge lie within reach, in tori.
    const auto images = [wraps](double at, double low, double high, double reach, double torus) {
        if (!wraps) return std::array<int, 2>{0, 0};
        return std::array<int, 2>{static_cast<int>(std::floor((at - reach - high) / torus)) + 1,
                                  static_cast<int>(std::ceil((at + reach - low) / torus)) - 1};
    };
    const Capsules& capsules = world_->capsules;
    for (std::uint32_t i = 0; i < capsules.size(); ++i) {
        if (is_held(*world_, capsules.id[i]) || !ball_meets(ball, i)) continue;
        const Capsule& shape = capsules.shape[i];
        const double reach = 1.01 * (way + static_cast<double>(radius(ball)) + shape.radius);
        const auto [left, right] = std::minmax(shape.start.x, shape.end.x);
        const auto [low, high] = std::minmax(shape.start.y, shape.end.y);
        if (!wraps && (begin.x + reach < left || begin.x - reach > right || begin.y + reach < low ||
                       begin.y - reach > high))
            continue;
        const auto [first_across, last_across] = images(begin.x, left, right, reach, torus_.x);
        const auto [first_along, last_along] = images(begin.y, low, high, reach, torus_.y);
        for (int across = first_across; across <= last_across; ++across)
            for (int along = first_along; along <= last_along; ++along) {
                if (rests_on_edge(path, i, across, along)) continue;
                const Vec2 shift{torus_.x * across, torus_.y * along};
                const auto time = edge_closing(path, Edge<Real>(shape, shift), radius(ball), field_,
                                               now_, search_);
                if (time && *time < now_ &&
                    is_solid_for(i, state_at(path, field_, *time).position, shift))
                    return true;
            }
    }
    return false;
}

template class EventEngine<double>;
template class EventEngine<Wide>;

}  // namespace carom
