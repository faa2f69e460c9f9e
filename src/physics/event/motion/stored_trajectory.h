#pragma once

#include <bit>
#include <cstdint>

#include "physics/event/motion/trajectory.h"

/// Trajectories as the world stores them, and digests of them and of what supports them, by which a
/// tick tells whether they still hold.
namespace carom {

Trajectory<double> path_from(const BallPath& stored, const PathBend& bend);
inline BallPath stored_line(BallId id, const LinearPart<double>& line) {
    return {.id = id,
            .quick = static_cast<std::uint16_t>(line.recent_collisions),
            .motion = line.motion,
            .time = line.time,
            .position = Vec2(line.position),
            .velocity = Vec2(line.velocity)};
}
PathBend stored_bend(const World& world, const Trajectory<double>& path);

/// PathBend::carriers of a ball with these supports: a digest of where the edges among them are and
/// on which side they are solid; 0 where there are none. An edge that is gone or held counts as one
/// of another shape.
std::uint32_t sum_of_carriers(const World& world, const PathSupport& support,
                              const PathSupport& second);

/// SolverMemory::paths_obstacles: a digest of the edges that nothing holds, of the radii, and of
/// which kinds collide; never 0.
std::uint64_t sum_of_obstacles(const World& world);

inline std::uint64_t stirred(std::uint64_t sum, std::uint64_t word) {
    return std::rotl(sum ^ word, 29) * 0x9fb21c651e98df25u;
}
inline std::uint64_t stirred(std::uint64_t sum, double value) {
    return stirred(sum, std::bit_cast<std::uint64_t>(value));
}
inline std::uint64_t stirred(std::uint64_t sum, Vec2 v) {
    return stirred(stirred(sum, v.x), v.y);
}

}  // namespace carom
