#include "game/commands/aiming.h"

#include "geometry/impact.h"

namespace carom {
namespace {

/// Longer than any table, in radii of the ball.
constexpr double far = 1000.0;
/// A shorter tangent is the rounding error of a full hit.
constexpr double full = 1e-6;

}  // namespace

std::optional<AimLine> aim_line(const World& world, BallId ball, Vec2 direction) {
    const auto struck = index_of(world, ball);
    const double size = length(direction);
    if (!struck || !(size > 0.0)) return std::nullopt;
    const Vec2 way = direction / size;
    const Disc disc{world.balls().position[*struck], world.balls().radius[*struck]};
    double reach = far * disc.radius;
    AimLine line;
    line.from = disc.center;
    for (const Capsule& edge : world.capsules().shape)
        if (const auto impact = first_impact(disc, way, edge, reach)) reach = impact->time;
    std::optional<std::size_t> object;
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        if (i == *struck) continue;
        const Disc other{world.balls().position[i], world.balls().radius[i]};
        const auto impact = first_impact(disc, way, other, reach);
        if (!impact) continue;
        reach = impact->time;
        object = i;
    }
    line.to = disc.center + way * reach;
    if (!object) return line;
    line.object = world.balls().id[*object];
    const Vec2 apart = world.balls().position[*object] - line.to;
    line.object_way = apart / length(apart);
    line.cut_cosine = dot(way, line.object_way);
    const Vec2 across = way - line.object_way * line.cut_cosine;
    if (length(across) > full) line.tangent = across / length(across);
    return line;
}

Vec2 ghost_place(Vec2 object, double object_radius, double radius, Vec2 target) {
    const Vec2 way = target - object;
    return object - way * ((object_radius + radius) / length(way));
}

}  // namespace carom
