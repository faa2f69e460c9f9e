#include "lab/observe/pairs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/broad_phase/cell_frame.h"

namespace carom {
namespace {

constexpr double pi = 3.14159265358979323846;

// Points sorted into square cells that are at least `reach` wide, so that all pairs within reach
// are in one cell or in neighbours.
class PointGrid {
  public:
    PointGrid(const std::vector<Vec2>& points, double reach) {
        Box bounds{points.front(), points.front()};
        for (const Vec2 point : points)
            bounds = join(bounds, {point, point});
        low_ = bounds.low;
        columns_ = cells_in(bounds.high.x - bounds.low.x, reach, width_.x);
        rows_ = cells_in(bounds.high.y - bounds.low.y, reach, width_.y);
        begins_.assign(columns_ * rows_ + 1, 0);
        for (const Vec2 point : points)
            ++begins_[cell_of(point) + 1];
        for (std::size_t i = 1; i < begins_.size(); ++i)
            begins_[i] += begins_[i - 1];
        order_.resize(points.size());
        std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
        for (std::size_t i = 0; i < points.size(); ++i)
            order_[next[cell_of(points[i])]++] = i;
    }

    // Calls `visit(i, j)` for each pair in one cell or in neighbours, once.
    template <class Visit>
    void for_pairs(const Visit& visit) const {
        constexpr std::array<std::array<int, 2>, 4> half{{{1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
        for (std::size_t row = 0; row < rows_; ++row) {
            for (std::size_t column = 0; column < columns_; ++column) {
                const std::size_t cell = row * columns_ + column;
                for (std::size_t a = begins_[cell]; a < begins_[cell + 1]; ++a) {
                    for (std::size_t b = a + 1; b < begins_[cell + 1]; ++b)
                        visit(order_[a], order_[b]);
                    for (const auto& [right, up] : half)
                        visit_cell(a, column, row, right, up, visit);
                }
            }
        }
    }

  private:
    static constexpr std::size_t most_cells_a_side = 1024;

    static std::size_t cells_in(double extent, double reach, double& width) {
        const double fitting = std::floor(extent / reach);
        const auto cells = static_cast<std::size_t>(
            std::clamp(fitting, 1.0, static_cast<double>(most_cells_a_side)));
        width = std::max(extent / static_cast<double>(cells), reach);
        return cells;
    }

    std::size_t cell_of(Vec2 point) const {
        const auto column = static_cast<std::size_t>((point.x - low_.x) / width_.x);
        const auto row = static_cast<std::size_t>((point.y - low_.y) / width_.y);
        return std::min(row, rows_ - 1) * columns_ + std::min(column, columns_ - 1);
    }

    template <class Visit>
    void visit_cell(std::size_t a, std::size_t column, std::size_t row, int right, int up,
                    const Visit& visit) const {
        if ((right < 0 && column == 0) || (right > 0 && column + 1 == columns_)) return;
        if (up > 0 && row + 1 == rows_) return;
        const std::size_t other = (row + static_cast<std::size_t>(up)) * columns_ + column +
                                  static_cast<std::size_t>(right);
        for (std::size_t b = begins_[other]; b < begins_[other + 1]; ++b)
            visit(order_[a], order_[b]);
    }

    Vec2 low_;
    Vec2 width_;
    std::size_t columns_ = 1;
    std::size_t rows_ = 1;
    std::vector<std::size_t> begins_;  // by cell; one more at the end
    std::vector<std::size_t> order_;
};

// The points, and on a torus the images that lie within `reach` of its sides, after them.
std::vector<Vec2> with_images(const std::vector<Vec2>& points, const Box& torus, double reach) {
    std::vector<Vec2> all = points;
    const Vec2 sides = size(torus);
    for (const Vec2 point : points) {
        for (int right = -1; right <= 1; ++right) {
            for (int up = -1; up <= 1; ++up) {
                if (right == 0 && up == 0) continue;
                const Vec2 image = point + Vec2{right * sides.x, up * sides.y};
                if (contains(grow(torus, reach), image)) all.push_back(image);
            }
        }
    }
    return all;
}

// The value at 1 of the parabola that fits the points best.
double extrapolated_to_one(std::span<const CurvePoint> points) {
    std::array<std::array<double, 4>, 3> rows{};  // normal equations, right-hand side last
    for (const CurvePoint& point : points) {
        const double x = point.x - 1.0;
        const std::array<double, 3> powers{1.0, x, x * x};
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j)
                rows[i][j] += powers[i] * powers[j];
            rows[i][3] += powers[i] * point.y;
        }
    }
    // Eliminates the higher powers; the matrix is positive definite.
    for (const std::size_t pivot : {std::size_t{2}, std::size_t{1}}) {
        for (std::size_t i = 0; i < pivot; ++i) {
            const double factor = rows[i][pivot] / rows[pivot][pivot];
            for (std::size_t j = 0; j < 4; ++j)
                rows[i][j] -= factor * rows[pivot][j];
        }
    }
    return rows[0][3] / rows[0][0];
}

}  // namespace

PairMeter::PairMeter(const Scene& scene, const World& start) {
    const std::vector<double>& radius = start.balls().radius;
    if (radius.size() < 2) return;
    region_ = region_of(scene, start);
    if (!region_ || !region_->sides) return;
    if (region_->is_torus) torus_ = *start.model().wrap;
    double sum = 0.0;
    for (const double r : radius)
        sum += r;
    diameter_ = 2.0 * sum / static_cast<double>(radius.size());
    is_of_one_size_ = std::ranges::all_of(radius, [&](double r) { return r == radius.front(); });
    const double shorter = std::min(region_->sides->x, region_->sides->y);
    const double most = (region_->is_torus ? shorter / 2.0 : shorter) / diameter_;
    const auto bins = static_cast<std::size_t>(std::min(reach, most) / bin_width);
    counts_.assign(bins, 0);
    reach_ = static_cast<double>(bins) * bin_width * diameter_;
}

void PairMeter::note_tick(const World& world) {
    const std::vector<Vec2>& balls = world.balls().position;
    if (counts_.empty() || balls.size() < 2) return;
    const std::size_t count = balls.size();
    const std::vector<Vec2> points = region_->is_torus ? with_images(balls, torus_, reach_) : balls;
    const double by_bin = 1.0 / (bin_width * diameter_);
    PointGrid(points, reach_).for_pairs([&](std::size_t a, std::size_t b) {
        // A pair across the border of a torus is seen twice: from each side, with an image.
        const std::size_t first = std::min(a, b);
        const std::size_t second = std::max(a, b);
        if (first >= count) return;  // of two images
        const double bin = length(points[a] - points[b]) * by_bin;
        if (bin < static_cast<double>(counts_.size()))
            counts_[static_cast<std::size_t>(bin)] += second >= count ? 1 : 2;
    });
    pairs_ += static_cast<double>(count) * static_cast<double>(count - 1) / 2.0;
}

double PairMeter::share_within(double distance) const {
    const double r = distance;
    if (region_->is_torus) return pi * r * r / region_->area;
    const auto [a, b] = *region_->sides;
    return r * r * (pi * a * b - 4.0 / 3.0 * (a + b) * r + r * r / 2.0) / (a * b * a * b);
}

Curve PairMeter::curve() const {
    Curve curve{"r", {}};
    if (!(pairs_ > 0.0)) return curve;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
        const double low = static_cast<double>(i) * bin_width;
        const double high = low + bin_width;
        const double expected =
            pairs_ * (share_within(high * diameter_) - share_within(low * diameter_));
        curve.points.push_back(
            {(low + high) / 2.0, static_cast<double>(counts_[i]) / 2.0 / expected, {}});
    }
    return curve;
}

std::optional<double> PairMeter::contact_value() const {
    constexpr auto first = static_cast<std::size_t>(1.0 / bin_width + 0.5);
    constexpr auto last = static_cast<std::size_t>(1.2 / bin_width + 0.5);
    if (!is_of_one_size_ || counts_.size() < last) return std::nullopt;
    const Curve all = curve();
    if (all.points.empty()) return std::nullopt;
    return extrapolated_to_one(std::span(all.points).subspan(first, last - first));
}

}  // namespace carom
