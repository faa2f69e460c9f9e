#include "physics/support/shaft.h"

#include <algorithm>
#include <cstddef>

#include "physics/support/dice.h"
#include "physics/support/scenes.h"

namespace carom::scenes {
namespace {

template <std::size_t N>
double one_of(Dice& dice, const double (&values)[N]) {
    return values[dice.below(static_cast<int>(N))];
}

}  // namespace

World shaft(std::uint64_t number) {
    Dice dice{number * 0x2545f4914f6cdd1du + 777};
    World world = empty();
    Model& model = world.edit_definition().model;
    model.gravity = Vec2{0.0, -10.0};
    const double restitution = one_of(dice, {0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99, 1.0});
    const double of_edge =
        dice.chance(0.5) ? restitution : one_of(dice, {0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99, 1.0});
    model.inelastic = restitution < 1.0 || of_edge < 1.0;
    if (dice.chance(0.25)) model.spin = 0.5;
    const double friction = dice.between(0.05, 0.8);
    world.edit_definition().rate = one_of(dice, {60.0, 120.0, 240.0, 500.0, 1000.0});
    world.edit_definition().kinds = {
        {.radius = 1.0, .mass = 1.0, .restitution = restitution, .friction = friction}};
    world.edit_definition().materials = {{.restitution = of_edge, .friction = friction}};
    const double wide = one_of(dice, {2.0001, 2.1, 2.5, 3.2, 3.9, 4.2, 6.0, 8.5});
    const auto count = static_cast<std::size_t>(3 + dice.below(dice.chance(0.3) ? 60 : 14));
    const double ratio = dice.chance(0.3) ? 1.0 : dice.scaled(2.0, 1000.0);
    const int pattern = dice.below(5);
    const double gap = dice.chance(0.3) ? 0.0 : dice.scaled(1e-6, 3.0);
    const double drop = dice.chance(0.5) ? 0.0 : dice.between(0.0, 8.0);
    const double shake = dice.chance(0.4) ? 0.0 : dice.scaled(1e-6, 2.0);
    const double spread = dice.chance(0.6) ? 0.0 : 0.3;
    add_capsule(world, {{-1.0, -1.0}, {wide + 1.0, -1.0}, 1.0}, 0);
    add_capsule(world, {{-1.0, -1.0}, {-1.0, 800.0}, 1.0}, 0);
    add_capsule(world, {{wide + 1.0, -1.0}, {wide + 1.0, 800.0}, 1.0}, 0);
    const auto columns = static_cast<std::size_t>(wide / 2.0);
    double y = drop;
    for (std::size_t i = 0; i < count; y += gap) {
        double top = 0.0;
        for (std::size_t column = 0; column < columns && i < count; ++column, ++i) {
            double mass = 1.0;
            if (pattern == 1 && i + columns >= count) mass = ratio;  // on top
            if (pattern == 2 && i % 2 == 1) mass = ratio;            // alternating
            if (pattern == 3 && i < columns) mass = ratio;           // below
            if (pattern == 4) mass = dice.scaled(1.0, std::max(1.0001, ratio));
            const double radius = 1.0 - (spread > 0.0 ? dice.between(0.0, spread) : 0.0);
            const double cell = wide / static_cast<double>(columns);
            const double slack = std::max(0.0, cell / 2 - radius);
            double x = cell * (static_cast<double>(column) + 0.5);
            if (dice.chance(0.7)) x += slack * dice.between(-1.0, 1.0);
            const Vec2 velocity{dice.between(-shake, shake), dice.between(-shake, shake)};
            add_ball(world, {.position = {x, y + radius},
                             .velocity = velocity,
                             .radius = radius,
                             .mass = mass});
            top = std::max(top, 2.0 * radius);
        }
        y += top;
    }
    return world;
}

}  // namespace carom::scenes
