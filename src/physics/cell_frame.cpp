#include "physics/cell_frame.h"

#include <algorithm>
#include <array>

namespace carom {
namespace {

// The smallest power of two that is at least `value`; 1 for what is not positive.
double power_of_two_above(double value) {
    if (!(value > 0.0) || !std::isfinite(value)) return 1.0;
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);  // exact, in [0.5, 1)
    return std::ldexp(1.0, fraction == 0.5 ? exponent - 1 : exponent);
}

struct Range {
    double low = 0.0;
    double high = 0.0;
};

// Where the middle four fifths of the balls are along one axis, by a sample.
Range middle_of(const std::vector<Vec2>& positions, double Vec2::*axis) {
    constexpr std::size_t most_samples = 64;
    std::array<double, most_samples> sample{};
    const std::size_t count = std::min(most_samples, positions.size());
    for (std::size_t i = 0; i < count; ++i)
        sample[i] = positions[i * positions.size() / count].*axis;
    std::sort(sample.begin(), sample.begin() + static_cast<std::ptrdiff_t>(count));
    return {sample[count / 10], sample[count - 1 - count / 10]};
}

// Where most of the balls are along one axis: the middle four fifths, with as much again on either
// side, snapped to a coarse lattice so that it seldom changes.
Range most_of(const std::vector<Vec2>& positions, double Vec2::*axis) {
    const auto [low, high] = middle_of(positions, axis);
    const double step = power_of_two_above((high - low) / 4);
    return {std::floor((low - (high - low) / 2) / step) * step,
            std::ceil((high + (high - low) / 2) / step) * step};
}

// Cells of at least `side` over what begins at the frame's origin, about `cells_a_point` at most.
CellFrame cells_over(CellFrame frame, Vec2 extent, double side, double points,
                     double cells_a_point) {
    const double most_cells = cells_a_point * points + 64.0;
    if (!(side > 0.0) || !std::isfinite(side)) side = 1.0;
    const double cells = (extent.x / side + 1.0) * (extent.y / side + 1.0);
    if (cells > most_cells)
        side = std::max({side * std::sqrt(cells / most_cells), 2.0 * extent.x / most_cells,
                         2.0 * extent.y / most_cells});
    frame.columns = std::max(1, static_cast<int>(std::min(1e6, extent.x / side)));
    frame.rows = std::max(1, static_cast<int>(std::min(1e6, extent.y / side)));
    frame.cell = {std::max(side, extent.x / frame.columns), std::max(side, extent.y / frame.rows)};
    if (frame.wraps) frame.cell = {extent.x / frame.columns, extent.y / frame.rows};
    return frame;
}

}  // namespace

CellFrame frame_around(const std::vector<Vec2>& points, double cell, double cells_a_point) {
    if (points.empty()) return {};
    CellFrame frame;
    const Range across = most_of(points, &Vec2::x);
    const Range along = most_of(points, &Vec2::y);
    frame.origin = {across.low, along.low};
    return cells_over(frame, {across.high - across.low, along.high - along.low}, cell,
                      static_cast<double>(points.size()), cells_a_point);
}

CellFrame frame_around(const World& world, double cell, double cells_a_ball) {
    const std::vector<Vec2>& positions = world.balls.position;
    if (!world.model.wrap || positions.empty()) return frame_around(positions, cell, cells_a_ball);
    CellFrame frame;
    frame.wraps = true;
    frame.origin = world.model.wrap->low;
    return cells_over(frame, size(*world.model.wrap), cell, static_cast<double>(positions.size()),
                      cells_a_ball);
}

double room_of_a_ball(const World& world) {
    const auto count = static_cast<double>(world.balls.size());
    if (count == 0.0) return 0.0;
    if (world.model.wrap) {
        const Vec2 torus = size(*world.model.wrap);
        return torus.x * torus.y / count;
    }
    const Range across = middle_of(world.balls.position, &Vec2::x);
    const Range along = middle_of(world.balls.position, &Vec2::y);
    return (across.high - across.low) * (along.high - along.low) / (0.64 * count);
}

double largest_radius(const Balls& balls) {
    double largest = 0.0;
    for (const double radius : balls.radius)
        largest = std::max(largest, radius);
    return largest;
}

Vec2 wrapped(Vec2 position, const Box& torus) {
    const Vec2 extent = size(torus);
    const auto wrap = [](double x, double low, double high, double width) {
        if (x >= low && x < high) return x;
        const double inside = x - width * std::floor((x - low) / width);
        return inside >= low && inside < high ? inside : low;  // rounding at the seam
    };
    return {wrap(position.x, torus.low.x, torus.high.x, extent.x),
            wrap(position.y, torus.low.y, torus.high.y, extent.y)};
}

void PointCells::rebuild(const CellFrame& frame, const std::vector<Vec2>& positions) {
    frame_ = frame;
    head_.assign(frame.count(), none);
    next_.resize(positions.size());
    before_.resize(positions.size());
    cell_.resize(positions.size());
    // From the last to the first, so that each cell lists its balls in ascending order.
    for (std::size_t i = positions.size(); i-- > 0;)
        insert(static_cast<std::uint32_t>(i),
               frame.index(frame.column(positions[i].x), frame.row(positions[i].y)));
}

void PointCells::move(std::size_t index, Vec2 position) {
    const std::uint32_t cell = frame_.index(frame_.column(position.x), frame_.row(position.y));
    if (cell == cell_[index]) return;
    const std::uint32_t next = next_[index];
    const std::uint32_t before = before_[index];
    if (before == none)
        head_[cell_[index]] = next;
    else
        next_[before] = next;
    if (next != none) before_[next] = before;
    insert(static_cast<std::uint32_t>(index), cell);
}

void PointCells::insert(std::uint32_t index, std::uint32_t cell) {
    cell_[index] = cell;
    before_[index] = none;
    next_[index] = head_[cell];
    if (next_[index] != none) before_[next_[index]] = index;
    head_[cell] = index;
}

}  // namespace carom
