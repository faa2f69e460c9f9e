#include "physics/broad_phase/near_pairs.h"

#include <algorithm>

#include "geometry/closest.h"

namespace carom {
void NearPairs::find(const World& world, const Regions& regions) {
    wraps_ = world.model().wrap.has_value();
    torus_ = wraps_ ? size(*world.model().wrap) : Vec2{};
    filtered_ = world.model().filtered;
    used_ = 0;
    pairs_.clear();
    loose_.clear();
    placed_.ball.resize(world.balls().size());
    if (placed_.ball.empty()) return;
    sort_into_levels(world, regions);
    sort_into_cells(world, regions);
    for (std::size_t fine = 0; fine < used_; ++fine) {
        if (world.model().ball_ball) {
            pair_within(world, levels_[fine]);
            for (std::size_t coarse = fine + 1; coarse < used_; ++coarse)
                pair_with_coarser(world, levels_[fine], levels_[coarse]);
        }
        if (world.model().ball_edge) pair_with_edges(world, levels_[fine]);
    }
}

// Calls note(place) for those of the places first..last-1 whose regions touch the given one. They
// are found first, without a branch that would be mispredicted.
template <typename Note>
inline void NearPairs::touching(const Placed& placed, Vec2 center, double reach,
                                std::uint32_t first, std::uint32_t last, Note&& note) {
    if (first >= last) return;
    if (touching_.size() < last - first) touching_.resize(last - first);
    std::uint32_t* const touching = touching_.data();
    std::size_t count = 0;
    for (std::uint32_t j = first; j < last; ++j) {
        Vec2 offset = center - placed.center[j];
        if (wraps_) offset = nearest_image(offset, torus_);
        const double both = reach + placed.reach[j];
        touching[count] = j;
        count += length_squared(offset) <= both * both ? 1 : 0;
    }
    for (std::size_t k = 0; k < count; ++k)
        note(touching[k]);
}

inline void NearPairs::consider(const World& world, std::uint32_t place, std::uint32_t first,
                                std::uint32_t last) {
    touching(placed_, placed_.center[place], placed_.reach[place], first, last,
             [&](std::uint32_t other) { note(world, placed_.ball[place], placed_.ball[other]); });
}

inline void NearPairs::note(const World& world, std::uint32_t first, std::uint32_t second) {
    if (filtered_ && !kinds_meet(world, world.balls().kind[first], world.balls().kind[second]))
        return;
    pairs_.push_back({.a = std::min(first, second), .b = std::max(first, second)});
}

// Finds each pair once: a ball is compared with those after it in its row of cells, and with the
// row above.
void NearPairs::pair_within(const World& world, const Level& level) {
    const CellFrame& frame = level.frame;
    const std::uint32_t* start = placed_.start.data() + level.first;
    if (wraps_) {
        pair_with_coarser(world, level, level);
        return;
    }
    for (int row = 0; row < frame.rows; ++row) {
        for (int column = 0; column < frame.columns; ++column) {
            const std::uint32_t cell = frame.index(column, row);
            const int last = std::min(column + 1, frame.columns - 1);
            const std::uint32_t row_end = start[frame.index(last, row) + 1];
            std::uint32_t above = 0;
            std::uint32_t above_end = 0;
            if (row + 1 < frame.rows) {
                above = start[frame.index(std::max(column - 1, 0), row + 1)];
                above_end = start[frame.index(last, row + 1) + 1];
            }
            for (std::uint32_t i = start[cell]; i < start[cell + 1]; ++i) {
                consider(world, i, i + 1, row_end);
                consider(world, i, above, above_end);
            }
        }
    }
}

void NearPairs::pair_with_coarser(const World& world, const Level& level, const Level& coarser) {
    const CellFrame& frame = coarser.frame;
    const bool same = &level == &coarser;
    const std::uint32_t* start = placed_.start.data() + coarser.first;
    const int across = frame.wraps ? std::min(3, frame.columns) : 3;
    const int along = frame.wraps ? std::min(3, frame.rows) : 3;
    if (!frame.wraps) {
        for (std::uint32_t i = level.begin; i < level.end; ++i) {
            const int column = frame.column(placed_.center[i].x);
            const int row = frame.row(placed_.center[i].y);
            const int left = std::max(column - 1, 0);
            const int right = std::min(column + 1, frame.columns - 1);
            for (int y = std::max(row - 1, 0); y <= std::min(row + 1, frame.rows - 1); ++y) {
                consider(world, i, start[frame.index(left, y)], start[frame.index(right, y) + 1]);
            }
        }
        return;
    }
    for (std::uint32_t i = level.begin; i < level.end; ++i) {
        const int column = frame.column(placed_.center[i].x);
        const int row = frame.row(placed_.center[i].y);
        for (int dy = 0; dy < along; ++dy) {
            int y = row - 1 + dy;
            y = frame.bounded(y, frame.rows);
            for (int dx = 0; dx < across; ++dx) {
                int x = column - 1 + dx;
                x = frame.bounded(x, frame.columns);
                const std::uint32_t cell = frame.index(x, y);
                const std::uint32_t first = same ? std::max(start[cell], i + 1) : start[cell];
                consider(world, i, first, start[cell + 1]);
            }
        }
    }
}

void NearPairs::pair_with_edges(const World& world, Level& level) {
    // The level's cells hold the edges that reach the largest of its regions.
    level.edges.update(world, level.frame, level.reach);
    const std::uint32_t* start = placed_.start.data() + level.first;
    for (const std::uint32_t cell : level.edges.occupied())
        for (std::uint32_t i = start[cell]; i < start[cell + 1]; ++i)
            for (const CapsuleEntry entry : level.edges.in_cell(cell))
                pair_with_edge(world, placed_.ball[i], placed_.center[i], placed_.reach[i], entry);
}

inline void NearPairs::pair_with_edge(const World& world, std::uint32_t ball, Vec2 center,
                                      double reach, const CapsuleEntry& entry) {
    if (filtered_ && !kind_meets_material(world, world.balls().kind[ball],
                                          world.capsules().material[entry.index]))
        return;
    const Capsule& shape = world.capsules().shape[entry.index];
    const Vec2 at = center - Vec2{entry.across * torus_.x, entry.along * torus_.y};
    const double both = reach + shape.radius;
    const Vec2 offset = at - closest_point(shape.start, shape.end, at);
    if (length_squared(offset) > both * both) return;
    pairs_.push_back({.a = ball,
                      .b = static_cast<std::uint32_t>(placed_.ball.size()),
                      .edge = entry.index,
                      .across = entry.across,
                      .along = entry.along});
}

bool NearPairs::is_cheaper_anew(const World& world, const Regions& regions,
                                std::span<const std::uint32_t> moved) const {
    if (used_ == 0 || 2 * (loose_.size() + moved.size()) > placed_.ball.size()) return true;
    const double largest = levels_[used_ - 1].reach;
    return std::ranges::any_of(moved, [&](std::uint32_t ball) {
        return world.balls().radius[ball] + regions.margin[ball] > largest;
    });
}

void NearPairs::find_moved(const World& world, const Regions& regions,
                           std::span<const std::uint32_t> moved) {
    has_moved_.resize(world.balls().size(), 0);
    for (const std::uint32_t ball : moved)
        has_moved_[ball] = 1;
    if (is_cheaper_anew(world, regions, moved)) {
        find(world, regions);
        std::erase_if(pairs_, [&](const NearPair& pair) {
            return has_moved_[pair.a] == 0 &&
                   (pair.edge != NearPair::no_edge || has_moved_[pair.b] == 0);
        });
    } else {
        take_out(moved);
        sort_loose(world, regions);
        pairs_.clear();
        for (const std::uint32_t ball : moved)
            pair_moved(world, ball, regions.center[ball],
                       world.balls().radius[ball] + regions.margin[ball]);
    }
    for (const std::uint32_t ball : moved)
        has_moved_[ball] = 0;
}

void NearPairs::pair_moved(const World& world, std::uint32_t ball, Vec2 center, double reach) {
    if (world.model().ball_ball) {
        for (std::size_t l = 0; l < used_; ++l)
            pair_moved_within(world, ball, center, reach, placed_, levels_[l].frame,
                              levels_[l].first, levels_[l].reach);
        pair_moved_within(world, ball, center, reach, placed_loose_, levels_[used_ - 1].frame, 0,
                          largest_loose_);
    }
    if (!world.model().ball_edge) return;
    std::size_t l = 0;
    while (reach > levels_[l].reach)
        ++l;
    const CellFrame& frame = levels_[l].frame;
    const std::uint32_t cell = frame.index(frame.column(center.x), frame.row(center.y));
    for (const CapsuleEntry entry : levels_[l].edges.in_cell(cell))
        pair_with_edge(world, ball, center, reach, entry);
}

// With the balls of some cells whose regions have radii of at most `largest`. A pair of two balls
// that have both moved is found from the lower one.
void NearPairs::pair_moved_within(const World& world, std::uint32_t ball, Vec2 center, double reach,
                                  const Placed& placed, const CellFrame& frame,
                                  std::uint32_t first_cell, double largest) {
    // Slightly more, since the numbers of cells are rounded.
    const double around = 1.000001 * (reach + largest);
    const int left = frame.column(center.x - around);
    const int right = frame.column(center.x + around);
    const int top = frame.row(center.y + around);
    const std::uint32_t* const start = placed.start.data() + first_cell;
    for (int row = frame.row(center.y - around); row <= top; ++row)
        touching(placed, center, reach, start[frame.index(left, row)],
                 start[frame.index(right, row) + 1], [&](std::uint32_t place) {
                     const std::uint32_t other = placed.ball[place];
                     if (has_moved_[other] != 0 && other <= ball) return;
                     note(world, ball, other);
                 });
}

}  // namespace carom
