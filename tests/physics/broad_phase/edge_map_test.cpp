#include "physics/broad_phase/edge_map.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "geometry/closest.h"
#include "physics/support/scenes.h"
#include "physics/world/random.h"

using namespace carom;

namespace {

double draw(double low, double high, std::uint64_t who, std::uint64_t index) {
    return random_between(low, high, 77, RandomStream::level, who, index);
}

Capsule some_capsule(std::uint64_t who, double from = -5.0, double to = 70.0) {
    return {{draw(from, to, who, 0), draw(from, to, who, 1)},
            {draw(from, to, who, 2), draw(from, to, who, 3)},
            draw(0.0, 1.0, who, 4)};
}

World some_edges(bool torus) {
    World world = scenes::gas(30, 12, torus);
    for (std::uint64_t i = 0; i < 60; ++i)
        add_capsule(world, some_capsule(i), 0);
    return world;
}

// Changes by kinematic bodies: some edges are grabbed, some released, some placed elsewhere.
void change_some(World& world, std::uint64_t round) {
    world.edit_held_capsules().clear();
    for (std::size_t i = 0; i < world.capsules().size(); ++i) {
        const std::uint64_t who = 1000 * (round + 1) + i;
        if (draw(0.0, 1.0, who, 5) < 0.03)
            world.edit_held_capsules().push_back({.id = world.capsules().id[i]});
        if (draw(0.0, 1.0, who, 6) < 0.04) world.edit_capsules().shape[i] = some_capsule(who);
    }
}

bool are_same(const CapsuleEntry& a, const CapsuleEntry& b) {
    return a.index == b.index && a.across == b.across && a.along == b.along;
}

}  // namespace

TEST_CASE("updated edges have the cells that building anew gives") {
    for (const bool torus : {false, true}) {
        World world = some_edges(torus);
        const CellFrame frame = frame_around(world, 4.0);
        CapsuleCells mended;
        mended.update(world, frame, 0.5);
        int mendings = 0;
        for (std::uint64_t round = 0; round < 200; ++round) {
            change_some(world, round);
            if (mended.mend(world))
                ++mendings;
            else
                mended.update(world, frame, 0.5);
            CapsuleCells anew;
            anew.update(world, frame, 0.5);
            REQUIRE(std::ranges::equal(mended.occupied(), anew.occupied()));
            for (std::uint32_t cell = 0; cell < frame.count(); ++cell)
                REQUIRE(std::ranges::equal(mended.in_cell(cell), anew.in_cell(cell), are_same));
        }
        CHECK(mendings > 150);
    }
}

TEST_CASE("other edges, or too many changed ones, are not updated in place") {
    World world = some_edges(false);
    CapsuleCells cells;
    CHECK_FALSE(cells.mend(world));
    cells.update(world, frame_around(world, 4.0), 0.5);
    CHECK(cells.mend(world));
    for (Capsule& shape : world.edit_capsules().shape)
        shape.start.x += 1.0;
    CHECK_FALSE(cells.mend(world));
    cells.update(world, frame_around(world, 4.0), 0.5);
    CHECK(cells.mend(world));
    add_capsule(world, some_capsule(5), 0);
    CHECK_FALSE(cells.mend(world));
}

TEST_CASE("each edge that a box touches is found once, wherever the box is") {
    World world = some_edges(false);
    add_capsule(world, {{-1e9, 3e8}, {-1e9, 4e8}, 2.0}, 0);  // far from all others
    add_capsule(world, {{-400.0, 20.0}, {900.0, 21.0}, 0.0}, 0);
    EdgeMap map;
    for (std::uint64_t round = 0; round < 40; ++round) {
        change_some(world, round);
        map.update(world);
        for (std::uint64_t k = 0; k < 100; ++k) {
            const std::uint64_t who = 100 * round + k;
            const double far = k % 10 == 0 ? 2e9 : 120.0;
            const Vec2 at{draw(-far, far, who, 7), draw(-far, far, who, 8)};
            const Disc disc{at, draw(0.0, 20.0, who, 9)};
            std::set<std::uint32_t> found;
            map.for_each_near(bounds(disc),
                              [&](std::uint32_t capsule) { CHECK(found.insert(capsule).second); });
            for (std::uint32_t c = 0; c < world.capsules().size(); ++c) {
                if (is_held(world, world.capsules().id[c]))
                    CHECK(found.count(c) == 0);
                else if (separation(disc, world.capsules().shape[c]) <= 0.0)
                    CHECK(found.count(c) == 1);
            }
        }
    }
}

TEST_CASE("a map suits a few balls among many edges, on a plane") {
    CHECK_FALSE(EdgeMap::suits(scenes::gas(30, 12)));
    CHECK_FALSE(EdgeMap::suits(some_edges(false)));
    World table = some_edges(false);
    while (table.balls().size() > 4)
        remove_ball(table, table.balls().id.back());
    CHECK(EdgeMap::suits(table));
    World torus = some_edges(true);
    while (torus.balls().size() > 4)
        remove_ball(torus, torus.balls().id.back());
    CHECK_FALSE(EdgeMap::suits(torus));
}
