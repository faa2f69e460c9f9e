#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

#include "physics/support/scenes.h"

/// Scenes in which balls gather on a floor, for tests of the hybrid step.
namespace carom::open_air {

/// Gravity 10, 100 ticks a second, balls of radius 0.5 and no edges.
inline World make(double restitution) {
    World world = scenes::empty();
    world.edit_definition().rate = 100.0;
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
    world.edit_definition().kinds[0] = {.radius = 0.5, .mass = 1.0, .restitution = restitution};
    world.edit_definition().materials[0].restitution = restitution;
    world.edit_definition().model.inelastic = restitution < 1.0;
    return world;
}

inline void add_floor(World& world) {
    add_capsule(world, {{-30.0, -1.0}, {30.0, -1.0}, 1.0}, 0);
}

inline std::vector<BallId> balls(std::initializer_list<std::uint32_t> numbers) {
    std::vector<BallId> ids;
    for (const std::uint32_t n : numbers)
        ids.push_back(BallId{n});
    return ids;
}

}  // namespace carom::open_air
