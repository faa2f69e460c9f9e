#include "physics/broad_phase/cell_frame.h"

#include <algorithm>
#include <limits>

#include <doctest/doctest.h>

#include "geometry/closest.h"
#include "physics/broad_phase/capsule_cells.h"
#include "physics/broad_phase/swept_cells.h"
#include "physics/support/scenes.h"
#include "physics/world/random.h"

using namespace carom;

namespace {

double draw(double low, double high, std::uint64_t who, std::uint64_t index) {
    return random_between(low, high, 99, RandomStream::level, who, index);
}

}  // namespace

TEST_CASE("an edge is in every cell from which a ball can touch it") {
    for (const bool torus : {false, true}) {
        World world = scenes::gas(300, 12, torus);
        for (std::uint64_t i = 0; i < 40; ++i)
            add_capsule(world,
                        {{draw(-5, 70, i, 4), draw(-5, 70, i, 5)},
                         {draw(-5, 70, i, 6), draw(-5, 70, i, 7)},
                         draw(0, 1, i, 8)},
                        0);
        const CellFrame frame = frame_around(world, 2.0);
        CapsuleCells edges;
        edges.update(world, frame, 1.0);
        const Vec2 around = torus ? size(*world.model().wrap) : Vec2{};
        for (std::uint64_t k = 0; k < 4000; ++k) {
            Vec2 p{draw(-20, 90, k, 9), draw(-20, 90, k, 10)};
            if (torus) p = wrapped(p, *world.model().wrap);
            const auto in_cell = edges.in_cell(frame.index(frame.column(p.x), frame.row(p.y)));
            for (std::uint32_t c = 0; c < world.capsules().size(); ++c) {
                for (int across = torus ? -1 : 0; across <= (torus ? 1 : 0); ++across) {
                    for (int along = torus ? -1 : 0; along <= (torus ? 1 : 0); ++along) {
                        Capsule image = world.capsules().shape[c];
                        const Vec2 shift{across * around.x, along * around.y};
                        image.start += shift;
                        image.end += shift;
                        if (separation(Disc{p, 1.0}, image) >= 0.0) continue;
                        CHECK(std::ranges::any_of(in_cell, [&](const CapsuleEntry& entry) {
                            return entry.index == c && entry.across == across &&
                                   entry.along == along;
                        }));
                    }
                }
            }
        }
    }
}

TEST_CASE("paths that come close share a cell, and each pair is found once") {
    World world = scenes::gas(200, 15);
    const CellFrame frame = frame_around(world, 3.0);
    SweptCells cells;
    cells.reset(frame, 200);
    std::vector<Box> boxes;
    for (std::uint32_t i = 0; i < 200; ++i) {
        const Vec2 p = world.balls().position[i];
        const Vec2 to = p + Vec2{draw(-30, 30, i, 11), draw(-30, 30, i, 12)};
        boxes.push_back(grow(join({p, p}, {to, to}), 1.0));
        cells.enter(i, grow({p, p}, 1.0), true);
        cells.enter(i, boxes.back(), false);
    }
    for (std::uint32_t i = 0; i < 200; ++i) {
        std::vector<std::uint32_t> sharing;
        cells.for_each_in(cells.range_of(boxes[i]), [&](std::uint32_t j) { sharing.push_back(j); });
        std::ranges::sort(sharing);
        CHECK(std::ranges::adjacent_find(sharing) == sharing.end());
        for (std::uint32_t j = 0; j < 200; ++j)
            if (overlaps(boxes[i], boxes[j])) CHECK(std::ranges::binary_search(sharing, j));
    }
}

// Regression: a ball in a jam entered its cells anew at every change of its path, and queries
// passed over all of these entries: a tick took 10 s (check-scenes 3047115).
TEST_CASE("a path that changes to and fro has one entry in a cell") {
    World world = scenes::gas(200, 15);
    SweptCells cells;
    cells.reset(frame_around(world, 3.0), 200);
    const Box here = grow({world.balls().position[0], world.balls().position[0]}, 1.0);
    const Vec2 aside = world.balls().position[0] + Vec2{4.0, 4.0};
    const Box there = grow({aside, aside}, 1.0);
    cells.enter(0, here, true);
    cells.enter(0, there, false);
    const std::size_t entries = cells.entry_count();
    for (int change = 0; change < 1000; ++change)
        cells.enter(0, change % 2 == 0 ? here : there, false);
    CHECK(cells.entry_count() == entries);
    for (const Box& box : {here, there}) {
        int found = 0;
        cells.for_each_in(cells.range_of(box), [&](std::uint32_t) { ++found; });
        CHECK(found == 1);
    }
}

// It counted a million columns and rows, and their product was too large for the index of a cell.
TEST_CASE("a frame around points that are nowhere has one cell") {
    for (const double nowhere :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        const std::vector<Vec2> points(9, Vec2{nowhere, 0.0});
        CHECK(frame_around(points, 1.0).count() == 1);
    }
}
