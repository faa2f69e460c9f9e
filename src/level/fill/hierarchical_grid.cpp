#include "level/fill/hierarchical_grid.h"

#include <cmath>

#include "geometry/closest.h"

namespace carom {
namespace {

int cells_along(double length, double cell) {
    return static_cast<int>(length / cell) + 1;
}

// separation(a, b) < 0, without its square root where the answer is far from rounding.
bool overlap(const Disc& a, const Disc& b) {
    constexpr double rounding = 1e-12;
    const double reach = a.radius + b.radius;
    const double square = length_squared(b.center - a.center);
    if (square > reach * reach * (1.0 + rounding)) return false;
    if (square < reach * reach * (1.0 - rounding)) return true;
    return separation(a, b) < 0.0;
}

}  // namespace

HierarchicalGrid::HierarchicalGrid(const Box& box, const std::vector<double>& radii) : box_(box) {
    for (std::size_t i = 0; i < radii.size();) {
        Grid grid;
        grid.largest = radii[i];
        const std::size_t first = i;
        while (i < radii.size() && radii[i] > 0.5 * grid.largest)
            ++i;
        // Limit the cells to a few for each disc, however large the box.
        const double most = 4.0 * static_cast<double>(i - first) + 16.0;
        const Vec2 extent = size(box);
        grid.cell = 2.0 * grid.largest;
        while ((extent.x / grid.cell + 1.0) * (extent.y / grid.cell + 1.0) > most) {
            grid.cell *= 1.4;
        }
        grid.columns = cells_along(extent.x, grid.cell);
        grid.rows = cells_along(extent.y, grid.cell);
        grid.first.assign(static_cast<std::size_t>(grid.columns) * grid.rows, -1);
        grids_.push_back(std::move(grid));
    }
}

int HierarchicalGrid::column(const Grid& grid, double x) const {
    return std::clamp(static_cast<int>((x - box_.low.x) / grid.cell), 0, grid.columns - 1);
}

int HierarchicalGrid::row(const Grid& grid, double y) const {
    return std::clamp(static_cast<int>((y - box_.low.y) / grid.cell), 0, grid.rows - 1);
}

void HierarchicalGrid::add(const Disc& disc) {
    std::size_t k = 0;
    while (k + 1 < grids_.size() && grids_[k + 1].largest >= disc.radius)
        ++k;
    Grid& grid = grids_[k];
    const auto cell = static_cast<std::size_t>(row(grid, disc.center.y)) * grid.columns +
                      column(grid, disc.center.x);
    next_.push_back(grid.first[cell]);
    grid.first[cell] = static_cast<std::int32_t>(discs_.size());
    discs_.push_back(disc);
}

bool HierarchicalGrid::touches(const Disc& disc, std::uint64_t& looks) const {
    for (const Grid& grid : grids_) {
        const double reach = disc.radius + grid.largest;
        const int last_row = row(grid, disc.center.y + reach);
        const int first_column = column(grid, disc.center.x - reach);
        const int last_column = column(grid, disc.center.x + reach);
        for (int r = row(grid, disc.center.y - reach); r <= last_row; ++r) {
            ++looks;
            for (int c = first_column; c <= last_column; ++c) {
                const auto cell = static_cast<std::size_t>(r) * grid.columns + c;
                for (std::int32_t i = grid.first[cell]; i >= 0;
                     i = next_[static_cast<std::size_t>(i)]) {
                    ++looks;
                    if (overlap(disc, discs_[static_cast<std::size_t>(i)])) return true;
                }
            }
        }
    }
    return false;
}

}  // namespace carom
