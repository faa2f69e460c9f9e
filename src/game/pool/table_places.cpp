#include "game/pool/table_places.h"

#include <algorithm>

#include "geometry/impact.h"
#include "level/scene/games.h"

namespace carom {
namespace {

bool is_free(const World& world, Vec2 place, double radius) {
    for (std::size_t i = 0; i < world.balls().size(); ++i)
        if (length(world.balls().position[i] - place) < radius + world.balls().radius[i])
            return false;
    return true;
}

}  // namespace

const Rack& rack_of(const Scene& scene) {
    return *std::ranges::find(scene.pool.racks, game_named(scene.game)->rack, &Rack::layout);
}

Vec2 head_spot(const Scene& scene) {
    // The head spot is as far from the centre of the table as the foot spot.
    Vec2 middle;
    for (const std::uint32_t pocket : scene.pool.pockets)
        middle += scene.world.zones()[pocket].shape.start;
    middle = middle / static_cast<double>(scene.pool.pockets.size());
    return middle * 2.0 - rack_of(scene).foot;
}

bool is_beyond_string(const Scene& scene, Vec2 place) {
    return dot(place - head_spot(scene), rack_of(scene).toward) >= 0.0;
}

bool is_on_table(const Scene& scene, const World& world, Vec2 place, double radius) {
    const Vec2 from = head_spot(scene);
    const Disc ball{from, radius};
    for (const Capsule& edge : world.capsules().shape)
        if (first_impact(ball, place - from, edge, 1.0)) return false;
    return std::ranges::none_of(scene.pool.pockets, [&](std::uint32_t pocket) {
        const Capsule& shape = scene.world.zones()[pocket].shape;
        return length(place - shape.start) < shape.radius;
    });
}

Vec2 free_place(const World& world, Vec2 spot, Vec2 direction, double radius) {
    constexpr int most_steps = 400;
    const double step = 0.05 * radius;
    for (const double sign : {1.0, -1.0})
        for (int i = 0; i < most_steps; ++i) {
            const Vec2 place = spot + direction * (sign * step * i);
            if (is_free(world, place, radius)) return place;
        }
    return spot;
}

}  // namespace carom
