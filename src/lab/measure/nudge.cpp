#include "lab/measure/nudge.h"

#include "physics/world/random.h"

namespace carom {

void nudge(World& world, double size, std::uint64_t seed, std::uint64_t copy) {
    const auto offset = [&](BallId id, std::uint64_t axis) {
        return random_between(-size, size, seed, RandomStream::lab, number(id), 2 * copy + axis);
    };
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        const BallId id = world.balls().id[i];
        world.edit_balls().position[i] += Vec2{offset(id, 0), offset(id, 1)};
    }
}

}  // namespace carom
