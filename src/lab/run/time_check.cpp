#include "lab/run/time_check.h"

#include <algorithm>

#include "physics/event/motion/event_memory.h"

namespace carom {
namespace {

// A slower ball may stay where it is by rounding, in radii a tick.
constexpr double least_motion = 1e-3;
// The widest gap between bodies that touch, as a share of the ball's radius.
constexpr double widest_gap = 1e-6;

// From the nearest point of the spine.
Vec2 offset_from(const Capsule& edge, Vec2 point) {
    const Vec2 span = edge.end - edge.start;
    const double whole = length_squared(span);
    const double share =
        whole > 0.0 ? std::clamp(dot(point - edge.start, span) / whole, 0.0, 1.0) : 0.0;
    return point - edge.start - span * share;
}

bool is_blocked(const World& world, std::size_t ball, Vec2 velocity) {
    const Balls& balls = world.balls();
    const Capsules& edges = world.capsules();
    const double reach = balls.radius[ball] * (1.0 + widest_gap);
    const auto leads_into = [&](Vec2 offset, double radius) {
        return length(offset) <= reach + radius && dot(velocity, offset) < 0.0;
    };
    for (std::size_t e = 0; e < edges.size() && world.model().ball_edge; ++e)
        if (kind_meets_material(world, balls.kind[ball], edges.material[e]) &&
            leads_into(offset_from(edges.shape[e], balls.position[ball]), edges.shape[e].radius))
            return true;
    for (std::size_t other = 0; other < balls.size() && world.model().ball_ball; ++other)
        if (other != ball && kinds_meet(world, balls.kind[ball], balls.kind[other]) &&
            leads_into(balls.position[ball] - balls.position[other], balls.radius[other]))
            return true;
    return false;
}

bool has_contact_stepped(const World& world, const Promise& promise, BallId ball) {
    return promise.iterates || std::ranges::binary_search(event_memory(world).clustered, ball);
}

}  // namespace

std::optional<Breach> find_ball_that_stays(const World& world, const Promise& promise,
                                           std::span<const Vec2> positions,
                                           std::span<const Vec2> velocities) {
    const Balls& balls = world.balls();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const double speed = std::min(length(velocities[i]), length(balls.velocity[i]));
        if (!(balls.position[i] == positions[i]) || is_held(world, balls.id[i]) ||
            !(speed * world.tick_length() > least_motion * balls.radius[i]))
            continue;
        if (has_contact_stepped(world, promise, balls.id[i]) &&
            is_blocked(world, i, velocities[i]) && is_blocked(world, i, balls.velocity[i]))
            continue;
        return Breach{
            .kind = Breach::Kind::time, .tick = world.tick(), .ball = balls.id[i], .amount = speed};
    }
    return std::nullopt;
}

}  // namespace carom
