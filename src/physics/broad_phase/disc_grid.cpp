#include "physics/broad_phase/disc_grid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "physics/memory/prefetch.h"
#include "physics/memory/zeros.h"

namespace carom {
namespace {

constexpr std::size_t most_levels = 32;

// Cells are this much wider than the largest disc, so that rounding puts no pair further apart than
// neighbouring cells; and what is looked for in cells is looked for this much further.
constexpr double slack = 1e-9;

struct AxisRange {
    double low = 0.0;
    double high = 0.0;
};

// The binary exponent of `value`. Pre: normal, > 0.
int exponent_of(double value) {
    return static_cast<int>(std::bit_cast<std::uint64_t>(value) >> 52 & 0x7ff) - 1023;
}

// The part of `whole` in which most are: the middle four fifths of a sample, with as much again on
// either side. A few that went far away must not make all cells large.
AxisRange most_of(std::span<const Vec2> centers, double Vec2::*axis, AxisRange whole) {
    constexpr std::size_t most_samples = 64;
    std::array<double, most_samples> sample{};
    const std::size_t count = std::min(most_samples, centers.size());
    for (std::size_t i = 0; i < count; ++i)
        sample[i] = centers[i * centers.size() / count].*axis;
    const auto end = sample.begin() + static_cast<std::ptrdiff_t>(count);
    const auto low_place = sample.begin() + static_cast<std::ptrdiff_t>(count / 10);
    const auto high_place = end - 1 - static_cast<std::ptrdiff_t>(count / 10);
    std::nth_element(sample.begin(), low_place, end);
    const double low = *low_place;
    std::nth_element(low_place, high_place, end);
    const double high = *high_place;
    const AxisRange range{std::max(whole.low, low - (high - low)),
                          std::min(whole.high, high + (high - low))};
    return range.low <= range.high ? range : AxisRange{};
}

// Outwards to a lattice, so that it seldom changes while the discs move about.
AxisRange snapped(AxisRange range) {
    const double extent = range.high - range.low;
    if (!(extent > std::numeric_limits<double>::min()) || !std::isfinite(extent))
        return {range.low, range.low + 1.0};
    const double step = std::ldexp(1.0, exponent_of(extent) - 5);
    return {std::floor(range.low / step) * step, std::ceil(range.high / step) * step};
}

Box where_most_are(std::span<const Vec2> centers) {
    constexpr double far = std::numeric_limits<double>::max();
    Vec2 low{far, far};
    Vec2 high{-far, -far};
    for (const Vec2 center : centers) {
        low = {center.x < low.x ? center.x : low.x, center.y < low.y ? center.y : low.y};
        high = {center.x > high.x ? center.x : high.x, center.y > high.y ? center.y : high.y};
    }
    const AxisRange across = snapped(most_of(centers, &Vec2::x, {low.x, high.x}));
    const AxisRange along = snapped(most_of(centers, &Vec2::y, {low.y, high.y}));
    return {{across.low, along.low}, {across.high, along.high}};
}

// Cells of at least `side` over the box, and no more than about four a disc.
CellFrame frame_over(const Box& box, double side, std::size_t discs, bool wraps) {
    CellFrame frame;
    frame.wraps = wraps;
    frame.origin = box.low;
    const Vec2 extent = size(box);
    const double most = 4.0 * static_cast<double>(discs) + 64.0;
    if (!(side > 0.0) || !std::isfinite(side)) side = 1.0;
    const double cells = (extent.x / side + 1.0) * (extent.y / side + 1.0);
    if (cells > most)
        side = std::max(
            {side * std::sqrt(cells / most), 2.0 * extent.x / most, 2.0 * extent.y / most});
    const auto along = [&](double length) {
        const int count = static_cast<int>(std::clamp(length / side, 1.0, 1e6));
        // A torus of two columns would have the same neighbour on either side.
        return wraps && count < 3 ? 1 : count;
    };
    frame.columns = along(extent.x);
    frame.rows = along(extent.y);
    frame.cell = {extent.x / frame.columns, extent.y / frame.rows};
    if (!wraps) frame.cell = {std::max(side, frame.cell.x), std::max(side, frame.cell.y)};
    return frame;
}

}  // namespace

std::uint32_t DiscGrid::place_along(double cells, int count) {
    const double most = count - 1;
    return static_cast<std::uint32_t>(cells > 0.0 ? (cells < most ? cells : most) : 0.0);
}

DiscGrid::Span DiscGrid::reached(double place, double reach, int count, bool wraps) {
    const double wide = reach * (1.0 + slack) + slack;
    if (!wraps)
        return {static_cast<int>(place_along(place - wide, count)),
                static_cast<int>(place_along(place + wide, count))};
    if (!(wide < 0.5 * count) || !(std::fabs(place) < 1e9)) return {0, count - 1};
    const Span span{static_cast<int>(std::floor(place - wide)),
                    static_cast<int>(std::floor(place + wide))};
    return {span.low, std::min(span.high, span.low + count - 1)};
}

std::size_t DiscGrid::level_for(double reach) const {
    const double share = reach * finest_scale_;  // in (0, 1)
    if (!(share > 1e-300)) return most_levels - 1;
    return std::min(most_levels - 1, static_cast<std::size_t>(-1 - exponent_of(share)));
}

void DiscGrid::choose_levels(std::span<const Vec2> centers, std::span<const double> radii,
                             double margin, const std::optional<Box>& torus) {
    double largest = 0.0;
    double smallest = std::numeric_limits<double>::max();
    for (const double radius : radii) {
        largest = radius > largest ? radius : largest;
        smallest = radius < smallest ? radius : smallest;
    }
    largest += margin;
    smallest += margin;
    levels_.assign(1, Level{});
    levels_[0].largest = largest;
    levels_[0].discs = static_cast<std::uint32_t>(centers.size());
    // A hair below 1, so that the largest falls into the coarsest level.
    finest_scale_ = (1.0 - slack) / largest;
    if (2.0 * smallest < largest) {
        levels_.assign(most_levels, Level{});
        for (const double radius : radii) {
            Level& level = levels_[level_for(radius + margin)];
            level.largest = std::max(level.largest, radius + margin);
            ++level.discs;
        }
        while (levels_.back().discs == 0)
            levels_.pop_back();
    }
    const Box box = torus ? *torus : where_most_are(centers);
    if (torus || !contains(box_, box.low) || !contains(box_, box.high) ||
        size(box_).x > 1.5 * size(box).x || size(box_).y > 1.5 * size(box).y)
        box_ = box;
    if (kept_.size() < levels_.size()) kept_.resize(levels_.size());
    torus_ = torus ? size(*torus) : Vec2{};
    std::uint32_t first = 0;
    for (std::size_t l = 0; l < levels_.size(); ++l) {
        Level& level = levels_[l];
        level.frame = frame_for(kept_[l], level, torus.has_value());
        level.per_cell = {1.0 / level.frame.cell.x, 1.0 / level.frame.cell.y};
        level.stride = static_cast<std::uint32_t>(level.frame.columns) + 1;
        level.first = first;
        first += level.cells();
    }
    assign_zeros(start_, first + 1);
}

const CellFrame& DiscGrid::frame_for(Kept& kept, const Level& level, bool wraps) const {
    const double side = 2.0 * level.largest * (1.0 + slack);
    const CellFrame fresh = frame_over(box_, side, level.discs, wraps);
    const auto fits = [](int old, int wanted) {
        return 4 * old >= 3 * wanted && 3 * old <= 4 * wanted;
    };
    if (kept.box == box_ && kept.frame.wraps == wraps && kept.side >= side &&
        kept.side <= 1.25 * side && fits(kept.frame.columns, fresh.columns) &&
        fits(kept.frame.rows, fresh.rows))
        return kept.frame;
    kept = {box_, side, fresh};
    return kept.frame;
}

// Stable: the discs of a cell stay in ascending order.
void DiscGrid::sort_by_cell(std::span<const Vec2> centers, std::span<const double> radii,
                            double margin) {
    const std::size_t count = centers.size();
    const auto enter = [&](std::size_t i, const Level& level) {
        const Vec2 place = centers[i] - level.frame.origin;
        const std::uint32_t cell =
            level.first + level.stride + 1 +
            place_along(place.y * level.per_cell.y, level.frame.rows) * level.stride +
            place_along(place.x * level.per_cell.x, level.frame.columns);
        cell_[i] = cell;
        ++start_[cell];
    };
    if (levels_.size() == 1) {
        const Level level = levels_[0];
        for (std::size_t i = 0; i < count; ++i)
            enter(i, level);
    } else {
        for (std::size_t i = 0; i < count; ++i)
            enter(i, levels_[level_for(radii[i] + margin)]);
    }
    std::uint32_t end = 0;
    for (std::uint32_t& start : start_)
        start = end += start;
    // The discs go to scattered places in memory: with many discs, these are prefetched.
    const std::size_t ahead = count >= too_many_to_cache ? 16 : count;
    for (std::size_t i = count; i-- > 0;) {
        if (i >= ahead) {
            prefetch_line(&start_[cell_[i - std::min(i, 2 * ahead)]]);
            prefetch_line(&places_[start_[cell_[i - ahead]] - 1]);
        }
        places_[--start_[cell_[i]]] = {centers[i], radii[i] + margin, static_cast<std::uint32_t>(i),
                                       cell_[i]};
    }
}

void DiscGrid::build(std::span<const Vec2> centers, std::span<const double> radii, double margin,
                     const std::optional<Box>& torus) {
    cell_.resize(centers.size());
    places_.resize(centers.size());
    if (centers.empty()) {
        levels_.assign(1, Level{});
        levels_[0].stride = 2;
        assign_zeros(start_, levels_[0].cells() + 1);
        return;
    }
    choose_levels(centers, radii, margin, torus);
    sort_by_cell(centers, radii, margin);
}

}  // namespace carom
