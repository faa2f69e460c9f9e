#include "physics/broad_phase/near_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "physics/memory/zeros.h"

// How NearPairs sorts balls into levels and cells.
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

// Where all regions are about as large as the mean one, one level holds all.
void NearPairs::sort_into_levels(const World& world, const Regions& regions) {
    const std::size_t count = world.balls().size();
    double sum = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double reach = world.balls().radius[i] + regions.margin[i];
        sum += reach;
        largest = std::max(largest, reach);
    }
    const double mean = sum / static_cast<double>(count);
    const double base = rounded_to_eighth_of_octave(largest <= 1.6 * mean ? largest : 1.25 * mean);

    constexpr int lowest = -60;
    std::array<std::uint32_t, 121> balls_in{};
    level_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        level_[i] = static_cast<std::uint8_t>(
            level_of(world.balls().radius[i] + regions.margin[i], base) - lowest);
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
                             : frame_around(regions.center, 2.0 * level.reach);
        level.first = cells;
        cells += static_cast<std::uint32_t>(level.frame.count());
    }
    for (std::uint8_t& l : level_)
        l = number[l];
    assign_zeros(placed_.start, cells + 1);
    frame_ = levels_[0].frame;
}

void NearPairs::sort_into_cells(const World& world, const Regions& regions) {
    const std::size_t count = placed_.ball.size();
    std::vector<std::uint32_t>& start = placed_.start;
    cell_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Level& level = levels_[level_[i]];
        const Vec2 at = regions.center[i];
        cell_[i] = level.first + level.frame.index(level.frame.column(at.x), level.frame.row(at.y));
        ++start[cell_[i] + 1];
    }
    for (std::size_t c = 1; c < start.size(); ++c)
        start[c] += start[c - 1];
    placed_.center.resize(count);
    placed_.reach.resize(count);
    // While they fill, cells begin where the next free place is, which in the end is where the next
    // cell begins.
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t place = start[cell_[i]]++;
        placed_.ball[place] = i;
        placed_.center[place] = regions.center[i];
        placed_.reach[place] = world.balls().radius[i] + regions.margin[i];
    }
    std::copy_backward(start.begin(), start.end() - 1, start.end());
    start[0] = 0;
    for (std::size_t l = 0; l < used_; ++l) {
        levels_[l].begin = start[levels_[l].first];
        levels_[l].end = start[levels_[l].first + levels_[l].frame.count()];
    }
}

// Takes balls out of the cells in which `find` has put them.
void NearPairs::take_out(std::span<const std::uint32_t> moved) {
    const std::size_t count = placed_.ball.size();
    if (loose_.empty()) {
        is_loose_.assign(count, 0);
        place_.resize(count);
        for (std::uint32_t place = 0; place < count; ++place)
            place_[placed_.ball[place]] = place;
    }
    for (const std::uint32_t ball : moved) {
        if (is_loose_[ball] != 0) continue;
        is_loose_[ball] = 1;
        loose_.push_back(ball);
        constexpr double nowhere = std::numeric_limits<double>::infinity();
        placed_.center[place_[ball]] = {nowhere, nowhere};
    }
}

// Into cells of the coarsest size.
void NearPairs::sort_loose(const World& world, const Regions& regions) {
    const CellFrame& frame = levels_[used_ - 1].frame;
    std::vector<std::uint32_t>& start = placed_loose_.start;
    assign_zeros(start, frame.count() + 1);
    for (const std::uint32_t ball : loose_) {
        const Vec2 at = regions.center[ball];
        cell_[ball] = frame.index(frame.column(at.x), frame.row(at.y));
        ++start[cell_[ball] + 1];
    }
    for (std::size_t c = 1; c < start.size(); ++c)
        start[c] += start[c - 1];
    placed_loose_.ball.resize(loose_.size());
    placed_loose_.center.resize(loose_.size());
    placed_loose_.reach.resize(loose_.size());
    largest_loose_ = 0.0;
    for (const std::uint32_t ball : loose_) {
        const std::uint32_t place = start[cell_[ball]]++;
        placed_loose_.ball[place] = ball;
        placed_loose_.center[place] = regions.center[ball];
        placed_loose_.reach[place] = world.balls().radius[ball] + regions.margin[ball];
        largest_loose_ = std::max(largest_loose_, placed_loose_.reach[place]);
    }
    std::copy_backward(start.begin(), start.end() - 1, start.end());
    start[0] = 0;
}

}  // namespace carom
