#pragma once

#include <bit>
#include <cstdint>

#include "physics/event/motion/event_memory.h"
#include "physics/event/motion/trajectory.h"

/// Trajectories as the world stores them, and digests of them and of what supports them, by which a
/// tick tells whether they still hold.
namespace carom {

Trajectory<double> trajectory_from(const StoredLinearPart& stored, const StoredCurvedPart& curve);
inline StoredLinearPart stored_linear_part(BallId id, const LinearPart<double>& line) {
    return {.id = id,
            .recent_collisions = static_cast<std::uint16_t>(line.recent_collisions),
            .motion = line.motion,
            .time = line.time,
            .position = Vec2(line.position),
            .velocity = Vec2(line.velocity)};
}
StoredCurvedPart stored_curved_part(const World& world, const Trajectory<double>& trajectory);

/// StoredCurvedPart::support_digest of a ball with these supports: a digest of where the edges
/// among them are and on which side they are solid; 0 where there are none. An edge that is gone or
/// held counts as one of another shape.
std::uint32_t digest_of_supports(const World& world, const SupportId& support,
                                 const SupportId& second);

/// StoredTrajectories::obstacles: a digest of the edges that nothing holds, of the radii, and of
/// which kinds collide; never 0.
std::uint64_t digest_of_obstacles(const World& world);

inline std::uint64_t digest_with(std::uint64_t digest, std::uint64_t word) {
    return std::rotl(digest ^ word, 29) * 0x9fb21c651e98df25u;
}
inline std::uint64_t digest_with(std::uint64_t digest, double value) {
    return digest_with(digest, std::bit_cast<std::uint64_t>(value));
}
inline std::uint64_t digest_with(std::uint64_t digest, Vec2 v) {
    return digest_with(digest_with(digest, v.x), v.y);
}

}  // namespace carom
