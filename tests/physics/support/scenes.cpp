#include "physics/support/scenes.h"

#include <cmath>

#include "geometry/elementary.h"
#include "physics/tick/totals.h"
#include "physics/world/random.h"

namespace carom::scenes {
namespace {

double draw(std::uint64_t seed, std::uint64_t who, std::uint64_t index) {
    return random_between(-1.0, 1.0, seed, RandomStream::level, who, index);
}

}  // namespace

World empty() {
    World world;
    world.edit_definition().kinds.push_back({.radius = 1.0, .mass = 1.0, .restitution = 1.0});
    world.edit_definition().materials.push_back({});
    return world;
}

void add_walls(World& world, const Box& box) {
    const Box spine = grow(box, 1.0);
    const Vec2 corners[] = {
        spine.low, {spine.high.x, spine.low.y}, spine.high, {spine.low.x, spine.high.y}};
    for (int i = 0; i < 4; ++i)
        add_capsule(world, {corners[i], corners[(i + 1) % 4], 1.0}, 0);
}

World gas(std::size_t count, std::uint64_t seed, bool torus) {
    World world = empty();
    world.edit_definition().rate = 60.0;
    const double side = std::sqrt(static_cast<double>(count) * pi / 0.3);
    const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    const double pitch = side / static_cast<double>(columns);
    for (std::size_t i = 0; i < count; ++i) {
        const double slack = pitch / 2 - 1.0;
        const Vec2 cell{static_cast<double>(i % columns) + 0.5,
                        static_cast<double>(i / columns) + 0.5};
        // The sum of four uniform numbers is close enough to Gaussian.
        Vec2 velocity;
        for (std::uint64_t k = 0; k < 4; ++k)
            velocity += {draw(seed, i, 2 + 2 * k), draw(seed, i, 3 + 2 * k)};
        add_ball(world,
                 {.position = cell * pitch + Vec2{draw(seed, i, 0), draw(seed, i, 1)} * slack,
                  .velocity = velocity});
    }
    double squares = 0.0;
    for (const Vec2 v : world.balls().velocity)
        squares += length_squared(v);
    const double scale = 10.0 / std::sqrt(squares / static_cast<double>(count));
    for (Vec2& v : world.edit_balls().velocity)
        v *= scale;
    if (torus)
        world.edit_definition().model.wrap = Box{{0.0, 0.0}, {side, side}};
    else
        add_walls(world, {{0.0, 0.0}, {side, side}});
    return world;
}

World bucket(std::size_t count, double restitution) {
    World world = empty();
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
    world.edit_definition().kinds[0] = {.radius = 0.5, .mass = 1.0, .restitution = restitution};
    world.edit_definition().materials[0].restitution = restitution;
    add_walls(world, {{0.0, 0.0}, {20.0, 60.0}});
    for (std::size_t i = 0; i < count; ++i)
        add_ball(world,
                 {.position = {1.0 + 1.1 * static_cast<double>(i % 17) + 0.04 * draw(1, i, 0),
                               0.6 + 1.1 * static_cast<double>(i / 17)},
                  .velocity = {}});
    return world;
}

World blocks(double ratio) {
    World world = empty();
    add_capsule(world, {{0.0, -5.0}, {0.0, 5.0}, 0.0}, 0);
    add_ball(world, {.position = {3.0, 0.0}, .velocity = {}});
    add_ball(world, {.position = {7.0, 0.0}, .velocity = {-1.0, 0.0}, .mass = ratio});
    return world;
}

World cradle(std::size_t count, std::size_t in, double gap) {
    World world = empty();
    for (std::size_t i = 0; i < count; ++i) {
        const double away = i < in ? -5.0 : 0.0;
        add_ball(world, {.position = {static_cast<double>(i) * (2.0 + gap) + away, 0.0},
                         .velocity = {i < in ? 1.0 : 0.0, 0.0}});
    }
    return world;
}

}  // namespace carom::scenes
