#include "physics/tick/overlap.h"

#include <algorithm>

#include "geometry/closest.h"
#include "physics/broad_phase/nearest_image.h"

namespace carom {

double relative_overlap(const World& world, std::uint32_t ball, std::uint32_t other) {
    const Balls& balls = world.balls();
    const Vec2 offset = nearest_image(world, balls.position[ball] - balls.position[other]);
    return (balls.radius[ball] + balls.radius[other] - length(offset)) /
           std::min(balls.radius[ball], balls.radius[other]);
}

double relative_overlap(const World& world, std::uint32_t ball, const Capsule& edge) {
    const double radius = world.balls().radius[ball];
    return -separation(Disc{world.balls().position[ball], radius}, edge) / radius;
}

}  // namespace carom
