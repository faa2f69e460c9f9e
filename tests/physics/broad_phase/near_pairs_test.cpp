#include "physics/broad_phase/near_pairs.h"

#include <algorithm>
#include <tuple>

#include <doctest/doctest.h>

#include "geometry/closest.h"
#include "physics/support/scenes.h"
#include "physics/world/random.h"

using namespace carom;

namespace {

double draw_between(double low, double high, std::uint64_t who, std::uint64_t index) {
    return random_between(low, high, 78, RandomStream::level, who, index);
}

// Balls of radii from 0.1 to 1 and some edges, with a region around each ball.
struct Scene {
    World world = scenes::empty();
    std::vector<Vec2> center;
    std::vector<double> margin;
    std::uint64_t drawn = 0;

    Scene() {
        for (int i = 0; i < 8; ++i)
            add_capsule(world, {{2.0 * i, 3.0 * i}, {2.0 * i + 5.0, 2.5 * i}, 0.2}, 0);
        for (std::size_t i = 0; i < 400; ++i) {
            add_ball(world, {.position = {0.0, 0.0}, .radius = draw_between(0.1, 1.0, drawn, 2)});
            center.push_back({});
            margin.push_back(0.0);
            place(i, 0.3);
        }
    }
    // A new region, somewhere.
    void place(std::size_t i, double most) {
        ++drawn;
        center[i] = {draw_between(-5.0, 25.0, drawn, 0), draw_between(-5.0, 30.0, drawn, 1)};
        margin[i] = draw_between(0.0, most, drawn, 3);
    }
    double reach(std::uint32_t i) const { return world.balls().radius[i] + margin[i]; }
};

using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

std::vector<Key> sorted(std::span<const NearPair> pairs) {
    std::vector<Key> keys;
    for (const NearPair& pair : pairs)
        keys.emplace_back(pair.a, pair.b, pair.edge);
    std::ranges::sort(keys);
    return keys;
}

// The pairs of which one ball is among `balls`.
std::vector<Key> by_trying_all(const Scene& scene, std::span<const std::uint32_t> balls) {
    std::vector<Key> keys;
    const auto count = static_cast<std::uint32_t>(scene.center.size());
    const auto is_asked = [&](std::uint32_t i) {
        return std::ranges::find(balls, i) != balls.end();
    };
    for (std::uint32_t i = 0; i < count; ++i) {
        for (std::uint32_t j = i + 1; j < count; ++j)
            if ((is_asked(i) || is_asked(j)) &&
                length(scene.center[i] - scene.center[j]) <= scene.reach(i) + scene.reach(j))
                keys.emplace_back(i, j, NearPair::no_edge);
        for (std::uint32_t e = 0; is_asked(i) && e < scene.world.capsules().size(); ++e) {
            const Capsule& edge = scene.world.capsules().shape[e];
            const Vec2 nearest = closest_point(edge.start, edge.end, scene.center[i]);
            if (length(scene.center[i] - nearest) <= scene.reach(i) + edge.radius)
                keys.emplace_back(i, count, e);
        }
    }
    std::ranges::sort(keys);
    return keys;
}

std::vector<std::uint32_t> all_of(const Scene& scene) {
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < scene.center.size(); ++i)
        all.push_back(i);
    return all;
}

}  // namespace

TEST_CASE("near pairs: all that could touch are found, each once") {
    const Scene scene;
    NearPairs near;
    near.find(scene.world, {scene.center, scene.margin});
    const std::vector<Key> expected = by_trying_all(scene, all_of(scene));
    REQUIRE(expected.size() > 400);
    CHECK(sorted(near.pairs()) == expected);
    std::vector<std::uint32_t> order(near.order().begin(), near.order().end());
    std::ranges::sort(order);
    CHECK(order == all_of(scene));
}

// A few balls move again and again; then many at once; then one far away, with a huge region.
TEST_CASE("near pairs: those of balls that have moved since are found as well") {
    Scene scene;
    NearPairs near;
    near.find(scene.world, {scene.center, scene.margin});
    for (int round = 0; round < 60; ++round) {
        CAPTURE(round);
        std::vector<std::uint32_t> moved;
        for (std::uint32_t i = 0; i < scene.center.size(); ++i)
            if (draw_between(0.0, 1.0, i, static_cast<std::uint64_t>(100 + round)) <
                (round == 40 ? 0.7 : 0.02))
                moved.push_back(i);
        if (round == 55) moved = {17};
        for (const std::uint32_t i : moved)
            scene.place(i, round == 50 ? 6.0 : 0.3);
        if (round == 55) scene.center[17] = {1e6, -1e6};
        near.find_moved(scene.world, {scene.center, scene.margin}, moved);
        CHECK(sorted(near.pairs()) == by_trying_all(scene, moved));
    }
}
