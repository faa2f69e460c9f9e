#include "physics/contact_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/closest.h"

namespace carom {
namespace {

// `value` rounded up to one of eight steps an octave, so that the cells seldom change.
double rounded_up(double value) {
    if (!(value > 0.0) || !std::isfinite(value)) return 1.0;
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    return std::ldexp(std::ceil(fraction * 16.0) / 16.0, exponent);
}

// The level of a region: the least n with reach <= base 2^n.
int level_of(double reach, double base) {
    int exponent = 0;
    const double fraction = std::frexp(reach / base, &exponent);
    return std::clamp(fraction == 0.5 ? exponent - 1 : exponent, -60, 60);
}

}  // namespace

void NearPairs::find(const World& world, const std::vector<double>& margin) {
    wraps_ = world.model.wrap.has_value();
    torus_ = wraps_ ? size(*world.model.wrap) : Vec2{};
    filtered_ = world.model.filtered;
    pairs_.clear();
    used_ = 0;
    order_.clear();
    if (world.balls.size() == 0) return;
    sort_into_levels(world, margin);
    sort_into_cells(world);
    for (std::size_t fine = 0; fine < used_; ++fine) {
        if (world.model.ball_ball) {
            pair_within(world, levels_[fine]);
            for (std::size_t coarse = fine + 1; coarse < used_; ++coarse)
                pair_with_coarser(world, levels_[fine], levels_[coarse]);
        }
        if (world.model.ball_edge) pair_with_edges(world, levels_[fine]);
    }
}

// Where all regions are about as large as the mean one, one level holds all.
void NearPairs::sort_into_levels(const World& world, const std::vector<double>& margin) {
    const std::size_t count = world.balls.size();
    reach_.resize(count);
    double sum = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        reach_[i] = world.balls.radius[i] + margin[i];
        sum += reach_[i];
        largest = std::max(largest, reach_[i]);
    }
    const double mean = sum / static_cast<double>(count);
    const double base = rounded_up(largest <= 1.6 * mean ? largest : 1.25 * mean);

    constexpr int lowest = -60;
    std::array<std::uint32_t, 121> balls_in{};
    level_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        level_[i] = static_cast<std::uint8_t>(level_of(reach_[i], base) - lowest);
        ++balls_in[level_[i]];
    }
    std::array<std::uint8_t, 121> place{};
    std::uint32_t cells = 0;
    for (std::size_t l = 0; l < balls_in.size(); ++l) {
        if (balls_in[l] == 0) continue;
        place[l] = static_cast<std::uint8_t>(used_);
        if (used_ == levels_.size()) levels_.emplace_back();
        Level& level = levels_[used_++];
        level.reach = std::ldexp(base, static_cast<int>(l) + lowest);
        level.frame = frame_around(world, 2.0 * level.reach);
        level.first = cells;
        cells += static_cast<std::uint32_t>(level.frame.count());
    }
    for (std::uint8_t& l : level_)
        l = place[l];
    start_.assign(cells + 1, 0);
    frame_ = levels_[0].frame;
}

void NearPairs::sort_into_cells(const World& world) {
    const std::size_t count = world.balls.size();
    cell_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Level& level = levels_[level_[i]];
        const Vec2 at = world.balls.position[i];
        cell_[i] = level.first + level.frame.index(level.frame.column(at.x), level.frame.row(at.y));
        ++start_[cell_[i] + 1];
    }
    for (std::size_t c = 1; c < start_.size(); ++c)
        start_[c] += start_[c - 1];
    fill_.assign(start_.begin(), start_.end() - 1);
    order_.resize(count);
    place_.resize(count);
    around_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t at = fill_[cell_[i]]++;
        order_[at] = i;
        place_[at] = world.balls.position[i];
        around_[at] = reach_[i];
    }
    for (std::size_t l = 0; l < used_; ++l) {
        levels_[l].begin = start_[levels_[l].first];
        levels_[l].end = start_[levels_[l].first + levels_[l].frame.count()];
    }
}

bool NearPairs::is_near(std::uint32_t i, std::uint32_t j) const {
    Vec2 offset = place_[i] - place_[j];
    if (wraps_) offset = nearest_image(offset, torus_);
    const double reach = around_[i] + around_[j];
    return length_squared(offset) <= reach * reach;
}

void NearPairs::consider(const World& world, std::uint32_t i, std::uint32_t j) {
    if (!is_near(i, j)) return;
    const Balls& balls = world.balls;
    if (filtered_ && !kinds_meet(world, balls.kind[order_[i]], balls.kind[order_[j]])) return;
    const bool in_order = order_[i] < order_[j];
    pairs_.push_back({.a = in_order ? i : j, .b = in_order ? j : i});
}

// Each pair once: a ball looks at those after it in its row of cells, and at the row above.
void NearPairs::pair_within(const World& world, const Level& level) {
    const CellFrame& frame = level.frame;
    const std::uint32_t* start = start_.data() + level.first;
    if (wraps_) {
        pair_with_coarser(world, level, level);
        return;
    }
    for (std::uint32_t i = level.begin; i < level.end; ++i) {
        const std::uint32_t cell = cell_[order_[i]] - level.first;
        const auto column = static_cast<int>(cell % static_cast<std::uint32_t>(frame.columns));
        const auto row = static_cast<int>(cell / static_cast<std::uint32_t>(frame.columns));
        const int last = std::min(column + 1, frame.columns - 1);
        const std::uint32_t row_end = start[frame.index(last, row) + 1];
        for (std::uint32_t j = i + 1; j < row_end; ++j)
            consider(world, i, j);
        if (row + 1 == frame.rows) continue;
        const std::uint32_t above = start[frame.index(std::max(column - 1, 0), row + 1)];
        const std::uint32_t above_end = start[frame.index(last, row + 1) + 1];
        for (std::uint32_t j = above; j < above_end; ++j)
            consider(world, i, j);
    }
}

void NearPairs::pair_with_coarser(const World& world, const Level& level, const Level& coarser) {
    const CellFrame& frame = coarser.frame;
    const bool same = &level == &coarser;
    const std::uint32_t* start = start_.data() + coarser.first;
    const int across = frame.wraps ? std::min(3, frame.columns) : 3;
    const int along = frame.wraps ? std::min(3, frame.rows) : 3;
    for (std::uint32_t i = level.begin; i < level.end; ++i) {
        const int column = frame.column(place_[i].x);
        const int row = frame.row(place_[i].y);
        for (int dy = 0; dy < along; ++dy) {
            int y = row - 1 + dy;
            if (frame.wraps) y = frame.bounded(y, frame.rows);
            if (y < 0 || y >= frame.rows) continue;
            for (int dx = 0; dx < across; ++dx) {
                int x = column - 1 + dx;
                if (frame.wraps) x = frame.bounded(x, frame.columns);
                if (x < 0 || x >= frame.columns) continue;
                const std::uint32_t cell = frame.index(x, y);
                for (std::uint32_t j = start[cell]; j < start[cell + 1]; ++j)
                    if (!same || j > i) consider(world, i, j);
            }
        }
    }
}

void NearPairs::pair_with_edges(const World& world, Level& level) {
    // The level's cells hold the edges that reach the largest of its regions.
    level.edges.update(world, level.frame, level.reach);
    for (std::uint32_t i = level.begin; i < level.end; ++i) {
        for (const CapsuleEntry entry : level.edges.in_cell(cell_[order_[i]] - level.first)) {
            if (filtered_ && !kind_meets_material(world, world.balls.kind[order_[i]],
                                                  world.capsules.material[entry.index]))
                continue;
            const Capsule& shape = world.capsules.shape[entry.index];
            const Vec2 at = place_[i] - Vec2{entry.across * torus_.x, entry.along * torus_.y};
            const double reach = around_[i] + shape.radius;
            const Vec2 way = at - closest_point(shape.start, shape.end, at);
            if (length_squared(way) > reach * reach) continue;
            pairs_.push_back({.a = i,
                              .b = static_cast<std::uint32_t>(order_.size()),
                              .edge = entry.index,
                              .across = entry.across,
                              .along = entry.along});
        }
    }
}

}  // namespace carom
