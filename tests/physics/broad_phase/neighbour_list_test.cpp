#include "physics/broad_phase/neighbour_list.h"

#include <algorithm>

#include <doctest/doctest.h>

#include "geometry/closest.h"
#include "physics/support/scenes.h"
#include "physics/world/random.h"

using namespace carom;

namespace {

double draw(double low, double high, std::uint64_t who, std::uint64_t index) {
    return random_between(low, high, 55, RandomStream::level, who, index);
}

World gas_with_edges(bool torus) {
    World world = scenes::gas(300, 4, torus);
    for (std::uint64_t i = 0; i < 30; ++i)
        add_capsule(world,
                    {{draw(-5, 60, i, 0), draw(-5, 60, i, 1)},
                     {draw(-5, 60, i, 2), draw(-5, 60, i, 3)},
                     draw(0, 1, i, 4)},
                    0);
    for (std::size_t i = 0; i < 300; i += 3)
        world.edit_balls().radius[i] = draw(0.05, 2.0, i, 5);
    return world;
}

std::vector<BallPair> pairs_nearer_than(const World& world, double gap) {
    std::vector<BallPair> pairs;
    const Balls& balls = world.balls();
    for (std::uint32_t i = 0; i < balls.size(); ++i)
        for (std::uint32_t j = i + 1; j < balls.size(); ++j) {
            Vec2 offset = balls.position[i] - balls.position[j];
            if (world.model().wrap) offset = nearest_image(offset, size(*world.model().wrap));
            if (length(offset) < balls.radius[i] + balls.radius[j] + gap) pairs.push_back({i, j});
        }
    return pairs;
}

std::vector<EdgePair> edges_nearer_than(const World& world, const auto& gap_of) {
    std::vector<EdgePair> pairs;
    const std::int8_t tori = world.model().wrap ? 1 : 0;
    for (std::uint32_t i = 0; i < world.balls().size(); ++i)
        for (std::uint32_t c = 0; c < world.capsules().size(); ++c)
            for (std::int8_t along = -tori; along <= tori; ++along)
                for (std::int8_t across = -tori; across <= tori; ++across)
                    if (overlaps_edge(world, {i, c, along, across},
                                      {world.balls().position[i],
                                       world.balls().radius[i] + gap_of(world.balls().radius[i])}))
                        pairs.push_back({i, c, along, across});
    return pairs;
}

std::vector<EdgePair> edges_overlapping(const World& world) {
    return edges_nearer_than(world, [](double) { return 0.0; });
}

template <typename T>
std::vector<T> sorted(std::span<const T> values) {
    std::vector<T> list(values.begin(), values.end());
    std::ranges::sort(list);
    return list;
}

template <typename T>
std::vector<T> list(std::span<const T> values) {
    return {values.begin(), values.end()};
}

}  // namespace

TEST_CASE("the neighbour list has all pairs within the skin") {
    for (const bool torus : {false, true}) {
        const World world = gas_with_edges(torus);
        NeighbourList neighbours;
        for (const double margin : {0.0, 0.3}) {
            neighbours.build(world, margin);
            CHECK(sorted(neighbours.pairs()) == pairs_nearer_than(world, 2.0 * margin));
            CHECK(list(neighbours.edges()) == edges_nearer_than(world, [&](double radius) {
                      return neighbours.edge_margin(radius);
                  }));
            CHECK(neighbours.edges().size() > 20);
        }
    }
}

TEST_CASE("the neighbours of a ball are those of its pairs") {
    const World world = gas_with_edges(true);
    NeighbourList neighbours;
    neighbours.build(world, 0.4);
    neighbours.sort_pairs();
    neighbours.list_by_ball();
    std::size_t both_ways = 0;
    for (std::uint32_t i = 0; i < world.balls().size(); ++i) {
        const std::vector<std::uint32_t> others = sorted(neighbours.of(i));
        CHECK(std::ranges::adjacent_find(others) == others.end());
        for (const std::uint32_t j : neighbours.of(i)) {
            CHECK(std::ranges::binary_search(neighbours.pairs(),
                                             BallPair{std::min(i, j), std::max(i, j)}));
            ++both_ways;
        }
        for (const EdgePair& pair : neighbours.edges_of(i))
            CHECK(pair.ball == i);
    }
    CHECK(both_ways == 2 * neighbours.pairs().size());
}

TEST_CASE("the list is valid until a ball has moved further than the skin") {
    for (const bool torus : {false, true}) {
        World world = gas_with_edges(torus);
        NeighbourList neighbours;
        neighbours.build(world, 0.25);
        neighbours.sort_pairs();
        CHECK(neighbours.is_valid(world));
        for (std::size_t i = 0; i < world.balls().size(); ++i) {
            Vec2& position = world.edit_balls().position[i];
            position += Vec2{draw(-0.17, 0.17, i, 6), draw(-0.17, 0.17, i, 7)};
            if (torus) position = wrapped(position, *world.model().wrap);
        }
        CHECK(neighbours.is_valid(world));
        for (const BallPair& pair : pairs_nearer_than(world, 0.0))
            CHECK(std::ranges::binary_search(neighbours.pairs(), pair));
        for (const EdgePair& pair : edges_overlapping(world))
            CHECK(std::ranges::binary_search(neighbours.edges(), pair));
        world.edit_balls().position[200].y += 0.6;
        CHECK_FALSE(neighbours.is_valid_for(200, world.balls().position[200]));
        CHECK_FALSE(neighbours.is_valid(world));
    }
}

TEST_CASE("the list is valid until balls may have moved further than the skin") {
    World world = gas_with_edges(false);
    NeighbourList neighbours;
    neighbours.build(world, 0.25);
    CHECK(neighbours.is_valid_after(0.1));
    CHECK(neighbours.is_valid_after(0.1));
    CHECK_FALSE(neighbours.is_valid_after(0.1));
    // If all positions are checked, the positions count.
    world.edit_balls().position[7] += Vec2{0.0, 0.12};
    CHECK(neighbours.is_valid(world));
    CHECK(neighbours.is_valid_after(0.12));
    CHECK_FALSE(neighbours.is_valid_after(0.02));
    // A pushed ball has moved further than the others.
    neighbours.build(world, 0.25);
    CHECK(neighbours.is_valid_after(0.1));
    CHECK(neighbours.note_place(5, world.balls().position[5] + Vec2{0.2, 0.0}));
    CHECK_FALSE(neighbours.is_valid_after(0.1));
    neighbours.build(world, 0.25);
    CHECK_FALSE(neighbours.note_place(5, world.balls().position[5] + Vec2{0.3, 0.0}));
    CHECK_FALSE(neighbours.is_valid_after(0.0));
    // Without a margin there is nothing that lasts.
    neighbours.build(world, 0.0);
    CHECK_FALSE(neighbours.is_valid_after(0.0));
}

TEST_CASE("the list of other balls, or of another torus, is never valid") {
    const World world = gas_with_edges(true);
    NeighbourList neighbours;
    neighbours.build(world, 0.2);
    World larger = world;
    larger.edit_balls().radius[7] += 0.01;
    CHECK_FALSE(neighbours.is_valid(larger));
    World fewer = world;
    remove_ball(fewer, BallId{299});
    CHECK_FALSE(neighbours.is_valid(fewer));
    World flat = world;
    flat.edit_definition().model.wrap.reset();
    CHECK_FALSE(neighbours.is_valid(flat));
    neighbours.build(world, 0.0);
    CHECK_FALSE(neighbours.is_valid(world));
}

TEST_CASE("a list of discs that stand in for the balls") {
    const World world = gas_with_edges(false);
    World swollen = world;
    for (std::uint64_t i = 0; i < world.balls().size(); ++i) {
        swollen.edit_balls().position[i] += {draw(-2, 2, i, 10), draw(-2, 2, i, 11)};
        swollen.edit_balls().radius[i] *= 1.7;
    }
    NeighbourList neighbours;
    neighbours.build(world, swollen.balls().position, swollen.balls().radius);
    CHECK(sorted(neighbours.pairs()) == pairs_nearer_than(swollen, 0.0));
    for (const EdgePair& pair : edges_overlapping(swollen))
        CHECK(std::ranges::binary_search(neighbours.edges(), pair));
}

TEST_CASE("an escaped ball gets the edges near its present position") {
    const World world = gas_with_edges(true);
    NeighbourList neighbours;
    neighbours.build(world, 0.0);
    const Vec2 torus = size(*world.model().wrap);
    for (std::uint64_t k = 0; k < 400; ++k) {
        World strayed = world;
        const auto ball = static_cast<std::uint32_t>(k % 300);
        Vec2& position = strayed.edit_balls().position[ball];
        position = {draw(0, torus.x, k, 8), draw(0, torus.y, k, 9)};
        std::vector<EdgePair> told;
        neighbours.for_each_edge_at(ball, position,
                                    [&](const EdgePair& pair) { told.push_back(pair); });
        for (const EdgePair& pair : edges_overlapping(strayed))
            if (pair.ball == ball) CHECK(std::ranges::find(told, pair) != told.end());
    }
}

TEST_CASE("pairs come in ascending order, few or many") {
    for (const std::uint64_t count : {0, 3, 40, 3000}) {
        std::vector<BallPair> pairs;
        for (std::uint64_t i = 0; i < count; ++i) {
            const auto first = static_cast<std::uint32_t>(draw(0, 499, i, 20));
            pairs.push_back({first, first + 1 + static_cast<std::uint32_t>(draw(0, 9, i, 21))});
        }
        const std::vector<BallPair> wanted = sorted(std::span<const BallPair>(pairs));
        PairOrder order;
        order.sort(pairs, 510);
        CHECK(pairs == wanted);
    }
}
