#include "physics/support/cloth_table.h"

#include <cmath>

#include "physics/support/scenes.h"

namespace carom::scenes {

World cloth_table(double restitution, double friction, const Cloth& cloth) {
    World world = empty();
    world.edit_definition().rate = 240.0;
    world.edit_definition().model.spin = solid;
    world.edit_definition().model.cloth = cloth;
    world.edit_definition().kinds[0] = {
        .radius = pool_ball, .mass = 0.17, .restitution = restitution, .friction = friction};
    world.edit_definition().materials[0] = {.restitution = 0.85, .friction = 0.2};
    world.edit_definition().model.inelastic = true;
    return world;
}

void put(World& world, Vec2 position, Vec2 velocity, Vec2 roll, double spin) {
    add_ball(world, {.position = position, .velocity = velocity, .spin = spin, .roll = roll});
}

void put_cushions(World& world) {
    const auto [w, h] = half_table;
    const Vec2 corners[] = {{-w, -h}, {w, -h}, {w, h}, {-w, h}};
    for (int i = 0; i < 4; ++i)
        add_capsule(world, {corners[i], corners[(i + 1) % 4], 0.0}, 0);
}

World break_shot(double gap, Vec2 velocity, Vec2 roll, double spin, double off) {
    World world = cloth_table(0.95, 0.05);
    put_cushions(world);
    const double pitch = 2.0 * pool_ball + gap;
    for (int row = 0; row < 5; ++row)
        for (int place = 0; place <= row; ++place)
            put(world, {0.6 + row * pitch * std::sqrt(0.75), (place - 0.5 * row) * pitch});
    put(world, {-0.6, off}, velocity, roll, spin);
    return world;
}

}  // namespace carom::scenes
