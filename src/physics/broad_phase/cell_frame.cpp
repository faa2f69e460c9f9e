#include "physics/broad_phase/cell_frame.h"

#include <algorithm>
#include <array>
#include <limits>

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

// Some of the balls along one axis, in ascending order. Pre: there are balls.
class Sample {
  public:
    Sample(std::span<const Vec2> positions, double Vec2::*axis)
        : count_(std::min(places_.size(), positions.size())) {
        for (std::size_t i = 0; i < count_; ++i)
            places_[i] = positions[i * positions.size() / count_].*axis;
        std::sort(places_.begin(), places_.begin() + static_cast<std::ptrdiff_t>(count_));
    }
    Range all() const { return {places_[0], places_[count_ - 1]}; }
    Range middle_four_fifths() const {
        return {places_[count_ / 10], places_[count_ - 1 - count_ / 10]};
    }

  private:
    std::array<double, 64> places_{};
    std::size_t count_;
};

// Widened to multiples of `step`.
Range snapped(Range range, double step) {
    return {std::floor(range.low / step) * step, std::ceil(range.high / step) * step};
}

// Where most of the balls are along one axis: the middle four fifths, with as much again on either
// side, snapped to a coarse lattice so that it seldom changes.
Range most_of(const Sample& sample) {
    const auto [low, high] = sample.middle_four_fifths();
    const double more = (high - low) / 2;
    return snapped({low - more, high + more}, power_of_two_above((high - low) / 4));
}

// From the first to the last edge along one axis. Pre: there are edges.
Range edges_along(const Capsules& capsules, double Vec2::*axis) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Range range{infinity, -infinity};
    for (const Capsule& edge : capsules.shape) {
        range.low = std::min(range.low, std::min(edge.start.*axis, edge.end.*axis) - edge.radius);
        range.high = std::max(range.high, std::max(edge.start.*axis, edge.end.*axis) + edge.radius);
    }
    return range;
}

// Balls within edges are expected to stay there.
Range expected(const World& world, double Vec2::*axis) {
    const Sample sample(world.balls().position, axis);
    const Range most = most_of(sample);
    if (world.capsules().size() == 0) return most;
    Range edges = edges_along(world.capsules(), axis);
    edges = snapped(edges, power_of_two_above((edges.high - edges.low) / 64));
    const Range all = sample.all();
    if (!(edges.low <= all.low && all.high <= edges.high)) return most;
    return {std::max(most.low, edges.low), std::min(most.high, edges.high)};
}

// Cells of at least `side` over what begins at the frame's origin, about `cells_a_point` at most.
CellFrame cells_over(CellFrame frame, Vec2 extent, double side, double points,
                     double cells_a_point) {
    const double most_cells = cells_a_point * points + 64.0;
    if (!std::isfinite(extent.x) || !std::isfinite(extent.y)) extent = {};
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

CellFrame frame_around(std::span<const Vec2> points, double cell, double cells_a_point) {
    if (points.empty()) return {};
    CellFrame frame;
    const Range across = most_of(Sample(points, &Vec2::x));
    const Range along = most_of(Sample(points, &Vec2::y));
    frame.origin = {across.low, along.low};
    return cells_over(frame, {across.high - across.low, along.high - along.low}, cell,
                      static_cast<double>(points.size()), cells_a_point);
}

CellFrame frame_around(const World& world, double cell, double cells_a_ball) {
    const std::vector<Vec2>& positions = world.balls().position;
    if (positions.empty()) return {};
    const auto balls = static_cast<double>(positions.size());
    CellFrame frame;
    if (world.model().wrap) {
        frame.wraps = true;
        frame.origin = world.model().wrap->low;
        return cells_over(frame, size(*world.model().wrap), cell, balls, cells_a_ball);
    }
    const Range across = expected(world, &Vec2::x);
    const Range along = expected(world, &Vec2::y);
    frame.origin = {across.low, along.low};
    return cells_over(frame, {across.high - across.low, along.high - along.low}, cell, balls,
                      cells_a_ball);
}

double area_per_ball(const World& world) {
    const auto count = static_cast<double>(world.balls().size());
    if (count == 0.0) return 0.0;
    if (world.model().wrap) {
        const Vec2 torus = size(*world.model().wrap);
        return torus.x * torus.y / count;
    }
    const Range across = Sample(world.balls().position, &Vec2::x).middle_four_fifths();
    const Range along = Sample(world.balls().position, &Vec2::y).middle_four_fifths();
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

}  // namespace carom
