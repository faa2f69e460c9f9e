#include "physics/event/motion/stored_trajectory.h"

#include "physics/broad_phase/capsule_cells.h"

namespace carom {

Trajectory<double> trajectory_from(const StoredLine& stored, const StoredCurve& curve) {
    Trajectory<double> path;
    path.time = stored.time;
    path.position = Vector<double>(stored.position);
    path.velocity = Vector<double>(stored.velocity);
    path.acceleration = Vector<double>(curve.acceleration);
    path.center = Vector<double>(curve.center);
    path.motion = stored.motion;
    path.support = curve.support;
    path.second_support = curve.second_support;
    path.recent_collisions = stored.recent_collisions;
    return path;
}

StoredCurve stored_curve(const World& world, const Trajectory<double>& path) {
    return {.acceleration = Vec2(path.acceleration),
            .center = Vec2(path.center),
            .support = path.support,
            .second_support = path.second_support,
            .carriers = path.motion == Motion::free
                            ? 0
                            : digest_of_carriers(world, path.support, path.second_support)};
}

namespace {

std::uint64_t digest_with_edge(std::uint64_t digest, const World& world, std::size_t index) {
    const Capsule& shape = world.capsules().shape[index];
    const Side side = world.model().one_way ? world.capsules().side[index] : Side::both;
    // 0 and -0 are the same place.
    const Vec2 start = shape.start + Vec2{};
    const Vec2 end = shape.end + Vec2{};
    digest = digest_with(digest_with(digest_with(digest, start), end), shape.radius);
    return digest_with(digest, static_cast<std::uint64_t>(side));
}

}  // namespace

std::uint32_t digest_of_carriers(const World& world, const PathSupport& support,
                                 const PathSupport& second) {
    std::uint64_t digest = 0;
    for (const PathSupport& by : {support, second}) {
        if (by.by != PathSupport::By::edge) continue;
        digest = digest_with(digest, std::uint64_t{by.number});
        const auto index = index_of(world, CapsuleId{by.number});
        if (!index || is_held(world, CapsuleId{by.number})) continue;
        digest = digest_with_edge(digest, world, *index);
    }
    return static_cast<std::uint32_t>(digest >> 32);
}

std::uint64_t digest_of_obstacles(const World& world) {
    std::uint64_t digest = static_cast<std::uint64_t>(world.model().ball_edge);
    for (std::size_t i = 0; i < world.capsules().size(); ++i) {
        if (is_held(world, world.capsules().id[i])) continue;
        digest = digest_with(digest_with_edge(digest, world, i),
                             std::uint64_t{world.capsules().material[i]});
    }
    for (const double radius : world.balls().radius)
        digest = digest_with(digest, radius);
    if (world.model().filtered)
        for (const std::uint8_t meets : world.meets())
            digest = digest_with(digest, std::uint64_t{meets});
    return digest | 1;
}

}  // namespace carom
