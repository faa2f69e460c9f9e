#include "game/pool/table_places.h"

#include <algorithm>
#include <vector>

#include "geometry/impact.h"
#include "level/scene/games.h"

namespace carom {
bool is_free(const World& world, Vec2 place, double radius) {
    for (std::size_t i = 0; i < world.balls().size(); ++i)
        if (length(world.balls().position[i] - place) < radius + world.balls().radius[i])
            return false;
    return true;
}

const Rack& rack_of(const Scene& scene) {
    return *std::ranges::find(scene.pool.racks, game_named(scene.game)->rack, &Rack::layout);
}

int object_balls(const Scene& scene) {
    return static_cast<int>(rack_of(scene).balls.size() + scene.pool.others.size());
}

BallId first_ball(const Scene& scene, int ball) {
    if (ball == cue_ball) return scene.pool.cue->ball;
    const auto index = static_cast<std::size_t>(ball - 1);
    const std::vector<BallId>& racked = rack_of(scene).balls;
    return index < racked.size() ? racked[index] : scene.pool.others[index - racked.size()];
}

Vec2 home_of(const Scene& scene, int ball) {
    return scene.world.balls().position[*index_of(scene.world, first_ball(scene, ball))];
}

std::array<int, 2> foot_pockets(const Scene& scene) {
    const Vec2 head = head_spot(scene);
    const Vec2 toward = rack_of(scene).toward;
    const Vec2 right = -perpendicular(toward);
    std::array<int, 2> pockets{};
    for (const std::size_t side : {0u, 1u}) {
        const Vec2 corner = toward + right * (side == 0 ? 1.0 : -1.0);
        double furthest = 0.0;
        for (std::size_t i = 0; i < scene.pool.pockets.size(); ++i) {
            const Vec2 place = scene.world.zones()[scene.pool.pockets[i]].shape.start;
            const double reach = dot(place - head, corner);
            if (i > 0 && reach <= furthest) continue;
            furthest = reach;
            pockets[side] = static_cast<int>(i);
        }
    }
    return pockets;
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

bool is_in_hand_area(const Scene& scene, CueInHand in_hand, Vec2 place) {
    const Vec2 toward = rack_of(scene).toward;
    if (in_hand == CueInHand::anywhere) return true;
    if (in_hand == CueInHand::behind_head_string)
        return !(dot(place - head_spot(scene), toward) > 0.0);
    constexpr double rounding = 1e-9;  // of the radius
    const auto [middle, radius] = *scene.pool.d;
    const Vec2 from = place - middle;
    return dot(from, toward) <= rounding * radius && length(from) <= radius * (1.0 + rounding);
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
