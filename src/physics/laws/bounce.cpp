#include "physics/laws/bounce.h"

namespace carom {

Vec2 scattered_normal(const World& world, BallId id, std::uint32_t contact, Vec2 normal,
                      Vec2 velocity, double restitution) {
    constexpr std::uint64_t most_draws = 16;
    const double widest = *world.model().scatter;
    for (std::uint64_t draw = 0; draw < most_draws; ++draw) {
        const double angle = random_between(-widest, widest, world.seed(), RandomStream::scatter,
                                            number(id), contact * most_draws + draw);
        const auto [sine, cosine] = sin_cos(angle);
        const Vec2 turned = normal * cosine + perpendicular(normal) * sine;
        const double approach = -dot(velocity, turned);
        if (approach <= 0.0) continue;
        const Vec2 after = velocity + turned * ((1.0 + restitution) * approach);
        if (dot(after, normal) > 0.0) return turned;
    }
    return normal;
}

}  // namespace carom
