#include "physics/contact/constraint_order.h"

#include <algorithm>
#include <vector>

#include <doctest/doctest.h>

using namespace carom;

namespace {

// A column of balls, listed from the top down: ball i is at height 10 - 2 i, the last one on an
// edge.
struct Column {
    std::vector<Vec2> place{{0, 10}, {0, 8}, {0, 6}, {0, 4}, {0, 2}};
    std::vector<NearPair> pairs{{.a = 0, .b = 1},
                                {.a = 1, .b = 2},
                                {.a = 2, .b = 3},
                                {.a = 3, .b = 4},
                                {.a = 4, .b = 5, .edge = 0}};
};

std::vector<std::uint32_t> turns(const ConstraintOrder& order, std::size_t count) {
    std::vector<std::uint32_t> result;
    for (std::uint32_t k = 0; k < count; ++k)
        result.push_back(order[k]);
    return result;
}

bool share_ball(const NearPair& a, const NearPair& b, std::uint32_t balls) {
    return a.a == b.a || a.a == b.b || a.b == b.a || (a.b == b.b && a.b < balls);
}

}  // namespace

TEST_CASE(
    "constraint order: a column is solved from the bottom up, whatever the direction of gravity") {
    const Column column;
    ConstraintOrder order;
    order.arrange(column.pairs, column.place, {0.0, -9.81});
    CHECK(turns(order, 5) == std::vector<std::uint32_t>{4, 3, 2, 1, 0});
    order.arrange(column.pairs, column.place, {0.0, 9.81});
    CHECK(turns(order, 5) == std::vector<std::uint32_t>{0, 1, 2, 3, 4});
}

TEST_CASE(
    "constraint order: without gravity, and for a single pair, it is the order of the pairs") {
    const Column column;
    ConstraintOrder order;
    order.arrange(column.pairs, column.place, {});
    CHECK(turns(order, 5) == std::vector<std::uint32_t>{0, 1, 2, 3, 4});
    order.arrange(std::span(column.pairs).first(1), column.place, {0.0, -1.0});
    CHECK(turns(order, 1) == std::vector<std::uint32_t>{0});
}

TEST_CASE(
    "constraint order: each pair occurs once, in its relative order among pairs that share a "
    "ball") {
    // A brick wall: pairs side by side and diagonal ones, in random order.
    std::vector<Vec2> place;
    for (int row = 0; row < 12; ++row)
        for (int column = 0; column < 12; ++column)
            place.push_back({2.0 * column + (row % 2), 1.75 * row});
    const auto balls = static_cast<std::uint32_t>(place.size());
    std::vector<NearPair> pairs;
    for (std::uint32_t i = 0; i < balls; ++i)
        for (std::uint32_t j = i + 1; j < balls; ++j)
            if (length(place[i] - place[j]) < 2.1) pairs.push_back({.a = i, .b = j});
    for (std::uint32_t i = 0; i < 12; ++i)
        pairs.push_back({.a = i, .b = balls, .edge = 0});
    for (std::size_t k = 0; k < pairs.size(); ++k)
        std::swap(pairs[k], pairs[k * 7919 % pairs.size()]);

    ConstraintOrder order;
    order.arrange(pairs, place, {0.0, -1.0});
    const std::vector<std::uint32_t> result = turns(order, pairs.size());
    std::vector<std::uint32_t> sorted = result;
    std::ranges::sort(sorted);
    for (std::uint32_t k = 0; k < sorted.size(); ++k)
        REQUIRE(sorted[k] == k);

    const auto height = [&](const NearPair& pair) {
        return place[pair.a].y + (pair.b < balls ? place[pair.b].y : place[pair.a].y);
    };
    for (std::size_t k = 0; k < result.size(); ++k)
        for (std::size_t l = k + 1; l < result.size(); ++l)
            if (share_ball(pairs[result[k]], pairs[result[l]], balls))
                CHECK(height(pairs[result[k]]) <= height(pairs[result[l]]) + 0.02);
}

TEST_CASE(
    "constraint order: neighbours in the order rarely share a ball, so they can be computed in "
    "parallel") {
    std::vector<Vec2> place;
    std::vector<NearPair> pairs;
    // Twenty columns of ten, each listed from the bottom up.
    for (std::uint32_t column = 0; column < 20; ++column)
        for (std::uint32_t row = 0; row < 10; ++row) {
            const std::uint32_t ball = column * 10 + row;
            place.push_back({3.0 * column, 2.0 * row});
            if (row > 0) pairs.push_back({.a = ball - 1, .b = ball});
        }
    ConstraintOrder order;
    order.arrange(pairs, place, {0.0, -1.0});
    int sharing = 0;
    for (std::uint32_t k = 0; k + 1 < pairs.size(); ++k)
        if (share_ball(pairs[order[k]], pairs[order[k + 1]], 200)) ++sharing;
    CHECK(sharing <= 9);
}
