#include "physics/broad_phase/disc_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <doctest/doctest.h>

#include "physics/world/random.h"

using namespace carom;

namespace {

double draw(double low, double high, std::uint64_t who, std::uint64_t index) {
    return random_between(low, high, 77, RandomStream::level, who, index);
}

struct Discs {
    std::vector<Vec2> centers;
    std::vector<double> radii;
};

Discs scattered(std::size_t count, const Box& box, double smallest, double largest) {
    Discs discs;
    for (std::size_t i = 0; i < count; ++i) {
        discs.centers.push_back(
            {draw(box.low.x, box.high.x, i, 0), draw(box.low.y, box.high.y, i, 1)});
        discs.radii.push_back(smallest * std::pow(largest / smallest, draw(0, 1, i, 2)));
    }
    return discs;
}

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs by_grid(const DiscGrid& grid) {
    Pairs pairs;
    grid.for_each_pair([&](std::uint32_t a, std::uint32_t b) {
        pairs.push_back({std::min(a, b), std::max(a, b)});
    });
    std::ranges::sort(pairs);
    return pairs;
}

Pairs by_trying_all(const Discs& discs, double margin, const std::optional<Box>& torus) {
    Pairs pairs;
    for (std::uint32_t i = 0; i < discs.centers.size(); ++i)
        for (std::uint32_t j = i + 1; j < discs.centers.size(); ++j) {
            Vec2 offset = discs.centers[i] - discs.centers[j];
            if (torus) offset = nearest_image(offset, size(*torus));
            const double reach = (discs.radii[i] + margin) + (discs.radii[j] + margin);
            if (length_squared(offset) < reach * reach) pairs.push_back({i, j});
        }
    return pairs;
}

}  // namespace

TEST_CASE("the grid finds every pair once, whatever the radii and the torus") {
    struct Case {
        Box box;
        double smallest;
        double largest;
        bool torus;
    };
    const Case cases[] = {{{{0, 0}, {60, 60}}, 1, 1, false},
                          {{{0, 0}, {60, 60}}, 1, 1, true},
                          {{{-5, 3}, {95, 40}}, 0.5, 1.4, false},
                          {{{-5, 3}, {95, 40}}, 0.5, 1.4, true},
                          {{{0, 0}, {3000, 3000}}, 0.1, 1e3, false},
                          {{{0, 0}, {3000, 3000}}, 0.1, 1e3, true},
                          {{{0, 0}, {900, 3}}, 0.4, 0.4, true},
                          {{{0, 0}, {900, 1.9}}, 0.4, 0.4, true},
                          {{{0, 0}, {1.9, 900}}, 0.4, 0.4, true},
                          {{{0, 0}, {2.7, 2.7}}, 0.01, 0.4, true},
                          {{{0, 0}, {0, 0}}, 1, 1, false},
                          {{{0, 0}, {0, 500}}, 1, 30, false},
                          {{{1e9, -1e9}, {1e9 + 9, -1e9 + 9}}, 1e-3, 0.3, false}};
    DiscGrid grid;
    for (const Case& c : cases) {
        CAPTURE(c.box.high.x);
        CAPTURE(c.largest);
        CAPTURE(c.torus);
        const std::optional<Box> torus = c.torus ? std::optional(c.box) : std::nullopt;
        for (const double margin : {0.0, 0.05}) {
            const Discs discs = scattered(400, c.box, c.smallest, c.largest);
            grid.build(discs.centers, discs.radii, margin, torus);
            const Pairs pairs = by_grid(grid);
            CHECK(pairs == by_trying_all(discs, margin, torus));
            CHECK_FALSE(pairs.empty());
        }
    }
}

TEST_CASE("a frame is kept while discs move a little and are added, and finds every pair") {
    DiscGrid grid;
    const Box box{{0, 0}, {60, 40}};
    Discs discs;
    CellFrame last;
    int kept = 0;
    for (std::uint64_t round = 0; round < 80; ++round) {
        const Discs more = scattered(8, box, 0.5, 0.5 + 0.01 * static_cast<double>(round));
        discs.centers.insert(discs.centers.end(), more.centers.begin(), more.centers.end());
        discs.radii.insert(discs.radii.end(), more.radii.begin(), more.radii.end());
        for (std::size_t i = 0; i < discs.centers.size(); ++i)
            discs.centers[i] += {draw(-0.9, 1.0, i, round), draw(-0.9, 1.0, i, round + 1000)};
        const Pairs expected = by_trying_all(discs, 0.0, std::nullopt);
        grid.build(discs.centers, discs.radii, 0.0, std::nullopt);
        CHECK(by_grid(grid) == expected);
        kept += grid.frame(0) == last;
        last = grid.frame(0);
    }
    CHECK(kept > 10);
    CHECK(kept < 80);
}

TEST_CASE("distant discs, and discs with NaN positions, cost no pair") {
    Discs discs = scattered(300, {{0, 0}, {50, 50}}, 1, 1);
    for (std::uint64_t i = 0; i < 40; ++i)
        discs.centers[i * 7] = {draw(-1e4, 1e4, i, 4), draw(900, 910, i, 5)};
    discs.centers[5] = {1e300, -1e300};
    discs.centers[6] = {1e300, -1e300};
    discs.centers[8] = {std::numeric_limits<double>::quiet_NaN(), 1.0};
    discs.centers[9] = {std::numeric_limits<double>::infinity(), 1.0};
    DiscGrid grid;
    grid.build(discs.centers, discs.radii, 0.0, std::nullopt);
    CHECK(by_grid(grid) == by_trying_all(discs, 0.0, std::nullopt));
    grid.build({}, {}, 0.0, std::nullopt);
    CHECK(by_grid(grid).empty());
}

TEST_CASE("the grid finds everything that a disc touches, once each, wherever the disc is") {
    for (const bool is_torus : {false, true}) {
        const Box box{{0, 0}, {400, 300}};
        const Discs discs = scattered(500, box, 0.2, 50);
        const std::optional<Box> torus = is_torus ? std::optional(box) : std::nullopt;
        DiscGrid grid;
        grid.build(discs.centers, discs.radii, 0.0, torus);
        std::size_t touched = 0;
        for (std::uint64_t k = 0; k < 300; ++k) {
            const Disc disc{{draw(-500, 900, k, 6), draw(-500, 900, k, 7)}, draw(0, 40, k, 8)};
            std::vector<std::uint32_t> near;
            grid.for_each_near(disc.center, disc.radius,
                               [&](std::uint32_t i) { near.push_back(i); });
            std::ranges::sort(near);
            CHECK(std::ranges::adjacent_find(near) == near.end());
            for (std::uint32_t i = 0; i < discs.centers.size(); ++i) {
                Vec2 offset = disc.center - discs.centers[i];
                if (is_torus) offset = nearest_image(offset, size(box));
                if (length(offset) >= disc.radius + discs.radii[i]) continue;
                CHECK(std::ranges::binary_search(near, i));
                ++touched;
            }
        }
        CHECK(touched > 100);
    }
}

TEST_CASE("cells hold their discs in ascending order, and levels hold discs of similar size") {
    const Discs discs = scattered(1000, {{0, 0}, {2000, 2000}}, 0.5, 500);
    DiscGrid grid;
    grid.build(discs.centers, discs.radii, 0.0, std::nullopt);
    std::size_t seen = 0;
    for (std::size_t level = 0; level < grid.levels(); ++level) {
        const CellFrame& frame = grid.frame(level);
        for (int row = 0; row < frame.rows; ++row) {
            for (int column = 0; column < frame.columns; ++column) {
                std::vector<std::uint32_t> discs_here;
                grid.for_each_in_cell(level, column, row, [&](std::uint32_t i) {
                    discs_here.push_back(i);
                    CHECK(grid.level_of(i) == level);
                    CHECK(discs.radii[i] <= grid.reach(level));
                    CHECK(discs.radii[i] > 0.39 * grid.reach(level));
                });
                CHECK(std::ranges::is_sorted(discs_here));
                seen += discs_here.size();
            }
        }
    }
    CHECK(seen == 1000);
}
