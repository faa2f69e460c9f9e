#include "physics/broad_phase/near_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/closest.h"

namespace carom {
namespace {

// `value` rounded up to one of eight steps an octave, so that the cells seldom change.
double rounded_to_eighth_of_octave(double value) {
    if (!(value > 0.0) || !std::isfinite(value)) return 1.0;
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    return std::ldexp(std::ceil(fraction * 16.0) / 16.0, exponent);
}

// The level of a region: the least n with reach <= base 2^n.
int level_of(double reach, double base) {
    const double share = reach / base;
    if (share > 0.5 && share <= 1.0) return 0;
    int exponent = 0;
    const double fraction = std::frexp(share, &exponent);
    return std::clamp(fraction == 0.5 ? exponent - 1 : exponent, -60, 60);
}

}  // namespace

void NearPairs::sort(const World& world, const std::vector<Vec2>& place,
                     const std::vector<double>& margin, std::vector<std::uint32_t>& order) {
    wraps_ = world.model().wrap.has_value();
    torus_ = wraps_ ? size(*world.model().wrap) : Vec2{};
    filtered_ = world.model().filtered;
    used_ = 0;
    order.resize(world.balls().size());
    if (order.empty()) return;
    sort_into_levels(world, place, margin);
    sort_into_cells(place, order);
}

void NearPairs::find(const World& world, const Regions& regions) {
    pairs_.clear();
    for (std::size_t fine = 0; fine < used_; ++fine) {
        if (world.model().ball_ball) {
            pair_within(world, regions, levels_[fine]);
            for (std::size_t coarse = fine + 1; coarse < used_; ++coarse)
                pair_with_coarser(world, regions, levels_[fine], levels_[coarse]);
        }
        if (world.model().ball_edge) pair_with_edges(world, regions, levels_[fine]);
    }
}

void NearPairs::find(const World& world, const std::vector<double>& margin,
                     std::vector<std::uint32_t>& order) {
    sort(world, world.balls().position, margin, order);
    center_.clear();
    radius_.clear();
    margin_.clear();
    for (const std::uint32_t ball : order) {
        center_.push_back(world.balls().position[ball]);
        radius_.push_back(world.balls().radius[ball]);
        margin_.push_back(margin[ball]);
    }
    find(world, {.ball = order, .center = center_, .radius = radius_, .margin = margin_});
}

// Where all regions are about as large as the mean one, one level holds all.
void NearPairs::sort_into_levels(const World& world, const std::vector<Vec2>& place,
                                 const std::vector<double>& margin) {
    const std::size_t count = world.balls().size();
    double sum = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double reach = world.balls().radius[i] + margin[i];
        sum += reach;
        largest = std::max(largest, reach);
    }
    const double mean = sum / static_cast<double>(count);
    const double base = rounded_to_eighth_of_octave(largest <= 1.6 * mean ? largest : 1.25 * mean);

    constexpr int lowest = -60;
    std::array<std::uint32_t, 121> balls_in{};
    level_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        level_[i] =
            static_cast<std::uint8_t>(level_of(world.balls().radius[i] + margin[i], base) - lowest);
        ++balls_in[level_[i]];
    }
    std::array<std::uint8_t, 121> number{};
    std::uint32_t cells = 0;
    for (std::size_t l = 0; l < balls_in.size(); ++l) {
        if (balls_in[l] == 0) continue;
        number[l] = static_cast<std::uint8_t>(used_);
        if (used_ == levels_.size()) levels_.emplace_back();
        Level& level = levels_[used_++];
        level.reach = std::ldexp(base, static_cast<int>(l) + lowest);
        level.frame = wraps_ ? frame_around(world, 2.0 * level.reach)
                             : frame_around(place, 2.0 * level.reach);
        level.first = cells;
        cells += static_cast<std::uint32_t>(level.frame.count());
    }
    for (std::uint8_t& l : level_)
        l = number[l];
    start_.assign(cells + 1, 0);
    frame_ = levels_[0].frame;
}

void NearPairs::sort_into_cells(const std::vector<Vec2>& place, std::vector<std::uint32_t>& order) {
    const std::size_t count = place.size();
    cell_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Level& level = levels_[level_[i]];
        const Vec2 at = place[i];
        cell_[i] = level.first + level.frame.index(level.frame.column(at.x), level.frame.row(at.y));
        ++start_[cell_[i] + 1];
    }
    for (std::size_t c = 1; c < start_.size(); ++c)
        start_[c] += start_[c - 1];
    // While they fill, cells begin where the next free place is, which in the end is where the next
    // cell begins.
    for (std::uint32_t i = 0; i < count; ++i)
        order[start_[cell_[i]]++] = i;
    std::copy_backward(start_.begin(), start_.end() - 1, start_.end());
    start_[0] = 0;
    for (std::size_t l = 0; l < used_; ++l) {
        levels_[l].begin = start_[levels_[l].first];
        levels_[l].end = start_[levels_[l].first + levels_[l].frame.count()];
    }
}

// Notes those of the bodies first..last-1 whose regions touch that of i. They are found first,
// without a branch that would be mispredicted.
inline void NearPairs::consider(const World& world, const Regions& regions, std::uint32_t i,
                                std::uint32_t first, std::uint32_t last) {
    if (first >= last) return;
    if (touching_.size() < last - first) touching_.resize(last - first);
    const Vec2 center = regions.center[i];
    const double around = regions.radius[i] + regions.margin[i];
    std::uint32_t* const touching = touching_.data();
    std::size_t count = 0;
    for (std::uint32_t j = first; j < last; ++j) {
        Vec2 offset = center - regions.center[j];
        if (wraps_) offset = nearest_image(offset, torus_);
        const double reach = around + (regions.radius[j] + regions.margin[j]);
        touching[count] = j;
        count += length_squared(offset) <= reach * reach ? 1 : 0;
    }
    for (std::size_t k = 0; k < count; ++k)
        note(world, regions, i, touching[k]);
}

inline void NearPairs::note(const World& world, const Regions& regions, std::uint32_t i,
                            std::uint32_t j) {
    const std::uint32_t first = regions.ball[i];
    const std::uint32_t second = regions.ball[j];
    if (filtered_ && !kinds_meet(world, world.balls().kind[first], world.balls().kind[second]))
        return;
    const bool in_order = first < second;
    pairs_.push_back({.a = in_order ? i : j, .b = in_order ? j : i});
}

// Finds each pair once: a ball is compared with those after it in its row of cells, and with the
// row above.
void NearPairs::pair_within(const World& world, const Regions& regions, const Level& level) {
    const CellFrame& frame = level.frame;
    const std::uint32_t* start = start_.data() + level.first;
    if (wraps_) {
        pair_with_coarser(world, regions, level, level);
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
                consider(world, regions, i, i + 1, row_end);
                consider(world, regions, i, above, above_end);
            }
        }
    }
}

void NearPairs::pair_with_coarser(const World& world, const Regions& regions, const Level& level,
                                  const Level& coarser) {
    const CellFrame& frame = coarser.frame;
    const bool same = &level == &coarser;
    const std::uint32_t* start = start_.data() + coarser.first;
    const int across = frame.wraps ? std::min(3, frame.columns) : 3;
    const int along = frame.wraps ? std::min(3, frame.rows) : 3;
    if (!frame.wraps) {
        for (std::uint32_t i = level.begin; i < level.end; ++i) {
            const int column = frame.column(regions.center[i].x);
            const int row = frame.row(regions.center[i].y);
            const int left = std::max(column - 1, 0);
            const int right = std::min(column + 1, frame.columns - 1);
            for (int y = std::max(row - 1, 0); y <= std::min(row + 1, frame.rows - 1); ++y) {
                consider(world, regions, i, start[frame.index(left, y)],
                         start[frame.index(right, y) + 1]);
            }
        }
        return;
    }
    for (std::uint32_t i = level.begin; i < level.end; ++i) {
        const int column = frame.column(regions.center[i].x);
        const int row = frame.row(regions.center[i].y);
        for (int dy = 0; dy < along; ++dy) {
            int y = row - 1 + dy;
            y = frame.bounded(y, frame.rows);
            for (int dx = 0; dx < across; ++dx) {
                int x = column - 1 + dx;
                x = frame.bounded(x, frame.columns);
                const std::uint32_t cell = frame.index(x, y);
                const std::uint32_t first = same ? std::max(start[cell], i + 1) : start[cell];
                consider(world, regions, i, first, start[cell + 1]);
            }
        }
    }
}

void NearPairs::pair_with_edges(const World& world, const Regions& regions, Level& level) {
    // The level's cells hold the edges that reach the largest of its regions.
    level.edges.update(world, level.frame, level.reach);
    const std::uint32_t* start = start_.data() + level.first;
    for (const std::uint32_t cell : level.edges.occupied())
        for (std::uint32_t i = start[cell]; i < start[cell + 1]; ++i)
            for (const CapsuleEntry entry : level.edges.in_cell(cell))
                pair_with_edge(world, regions, i, entry);
}

inline void NearPairs::pair_with_edge(const World& world, const Regions& regions, std::uint32_t i,
                                      const CapsuleEntry& entry) {
    if (filtered_ && !kind_meets_material(world, world.balls().kind[regions.ball[i]],
                                          world.capsules().material[entry.index]))
        return;
    const Capsule& shape = world.capsules().shape[entry.index];
    const Vec2 at = regions.center[i] - Vec2{entry.across * torus_.x, entry.along * torus_.y};
    const double reach = (regions.radius[i] + regions.margin[i]) + shape.radius;
    const Vec2 offset = at - closest_point(shape.start, shape.end, at);
    if (length_squared(offset) > reach * reach) return;
    pairs_.push_back({.a = i,
                      .b = static_cast<std::uint32_t>(regions.ball.size()),
                      .edge = entry.index,
                      .across = entry.across,
                      .along = entry.along});
}

}  // namespace carom
