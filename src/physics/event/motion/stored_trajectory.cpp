#include "physics/event/motion/stored_trajectory.h"

#include "physics/broad_phase/capsule_cells.h"

namespace carom {

Trajectory<double> trajectory_from(const StoredLinearPart& stored, const StoredCurvedPart& curve) {
    Trajectory<double> trajectory;
    trajectory.time = stored.time;
    trajectory.position = Vector<double>(stored.position);
    trajectory.velocity = Vector<double>(stored.velocity);
    trajectory.acceleration = Vector<double>(curve.acceleration);
    trajectory.center = Vector<double>(curve.center);
    trajectory.motion = stored.motion;
    trajectory.support = curve.support;
    trajectory.second_support = curve.second_support;
    trajectory.recent_collisions = stored.recent_collisions;
    return trajectory;
}

StoredCurvedPart stored_curved_part(const World& world, const Trajectory<double>& trajectory) {
    return {.acceleration = Vec2(trajectory.acceleration),
            .center = Vec2(trajectory.center),
            .support = trajectory.support,
            .second_support = trajectory.second_support,
            .support_digest =
                trajectory.motion == Motion::free
                    ? 0
                    : digest_of_supports(world, trajectory.support, trajectory.second_support)};
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

std::uint32_t digest_of_supports(const World& world, const SupportId& support,
                                 const SupportId& second) {
    std::uint64_t digest = 0;
    for (const SupportId& each : {support, second}) {
        if (each.kind != SupportId::Kind::edge) continue;
        digest = digest_with(digest, std::uint64_t{each.number});
        const auto index = index_of(world, CapsuleId{each.number});
        if (!index || is_held(world, CapsuleId{each.number})) continue;
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
        for (const std::uint8_t meets : world.definition().meets)
            digest = digest_with(digest, std::uint64_t{meets});
    return digest | 1;
}

}  // namespace carom
