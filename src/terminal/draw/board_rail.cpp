#include "terminal/draw/board_rail.h"

#include <algorithm>
#include <cstddef>

#include "terminal/draw/board.h"

namespace carom {

namespace {

// The distance of each cell from the nearest one that is set, in cells, by steps to the eight
// neighbours. A `diagonal` step counts less than it is long, so that corners come out squarer.
std::vector<float> distance_from(const BoardGrid& grid, const CellMask& set,
                                 float diagonal = 1.2F) {
    // A border of cells far from everything gives each cell of the grid eight neighbours.
    const auto columns = static_cast<std::size_t>(grid.columns);
    const std::ptrdiff_t stride = grid.columns + 2;
    std::vector<float> bordered((columns + 2) * (static_cast<std::size_t>(grid.rows) + 2), 1e9F);
    const auto start_of = [&](int row) { return bordered.data() + (row + 1) * stride + 1; };
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set[i] != 0) start_of(static_cast<int>(i / columns))[i % columns] = 0.0F;
    // Relaxes a row from `cell` on. `step`: to the next cell; `past`: to the row before this one.
    const auto relax = [&](float* cell, std::ptrdiff_t step, std::ptrdiff_t past) {
        float before = cell[-step];
        for (const float* end = cell + step * grid.columns; cell != end; cell += step) {
            const float* above = cell + past;
            const float straight = (before < above[0] ? before : above[0]) + 1.0F;
            const float across = (above[-1] < above[1] ? above[-1] : above[1]) + diagonal;
            const float shorter = straight < across ? straight : across;
            if (shorter < *cell) *cell = shorter;
            before = *cell;
        }
    };
    for (int row = 0; row < grid.rows; ++row)
        relax(start_of(row), 1, -stride);
    for (int row = grid.rows - 1; row >= 0; --row)
        relax(start_of(row) + grid.columns - 1, -1, stride);
    std::vector<float> distance;
    distance.reserve(grid.size());
    for (int row = 0; row < grid.rows; ++row)
        distance.insert(distance.end(), start_of(row), start_of(row) + grid.columns);
    return distance;
}

double widest_pocket(const Scene& scene) {
    double radius = 0.0;
    for (const std::uint32_t pocket : scene.pool.pockets)
        radius = std::max(radius, scene.world.zones()[pocket].shape.radius);
    return radius;
}

// Squares off the bed where a pocket bites into it: around each pocket, what lies beside a part of
// the bed in its row and in its column becomes bed. So corners of the frame are not cut off.
void fill_bites(CellMask& bed, const Scene& scene, const BoardGrid& grid) {
    constexpr double reach = 4.0;  // radii of the pocket
    for (const std::uint32_t pocket : scene.pool.pockets) {
        const Capsule& shape = scene.world.zones()[pocket].shape;
        const Box around = grow(Box{shape.start, shape.start}, reach * shape.radius);
        const int left = grid.column_of(around.low.x);
        const int right = grid.column_of(around.high.x);
        const int top = grid.row_of(around.low.y);
        const int bottom = grid.row_of(around.high.y);
        std::vector<bool> has_in_column(static_cast<std::size_t>(right - left + 1));
        std::vector<bool> has_in_row(static_cast<std::size_t>(bottom - top + 1));
        const auto each_cell = [&](const auto& visit) {
            for (int row = top; row <= bottom; ++row)
                for (int column = left; column <= right; ++column)
                    visit(bed[grid.index(column, row)], static_cast<std::size_t>(column - left),
                          static_cast<std::size_t>(row - top));
        };
        each_cell([&](std::uint8_t cell, std::size_t column, std::size_t row) {
            if (cell != 0) has_in_column[column] = has_in_row[row] = true;
        });
        each_cell([&](std::uint8_t& cell, std::size_t column, std::size_t row) {
            if (has_in_column[column] && has_in_row[row]) cell = 1;
        });
    }
}

}  // namespace

std::vector<float> distance_from_bed(const Scene& scene, const BoardGrid& grid,
                                     const CellMask& bed) {
    constexpr float square = 1.0F;
    if (!is_pool_table(scene)) return distance_from(grid, bed);
    const double mouth = 1.7 * widest_pocket(scene) / grid.cell;
    if (mouth == 0.0) return distance_from(grid, bed, square);
    CellMask off_bed(grid.size());
    for (std::size_t i = 0; i < bed.size(); ++i)
        off_bed[i] = bed[i] == 0;
    const std::vector<float> depth = distance_from(grid, off_bed);
    CellMask deep(grid.size());
    for (std::size_t i = 0; i < bed.size(); ++i)
        deep[i] = static_cast<double>(depth[i]) > mouth;
    fill_bites(deep, scene, grid);
    std::vector<float> far = distance_from(grid, deep, square);
    for (float& distance : far)
        distance = std::max(0.0F, distance - static_cast<float>(mouth));
    return far;
}

CellMask jaws_of(const Scene& scene, const BoardGrid& grid, const CellMask& bed) {
    CellMask jaws(grid.size());
    if (!is_pool_table(scene) || scene.pool.pockets.empty()) return jaws;
    double radius = 0.0;
    for (const Capsule& edge : scene.world.capsules().shape)
        radius = std::max(radius, edge.radius);
    constexpr double blur = 1.5;  // cells that an edge is marked wider than it is
    const auto half = static_cast<float>(std::min(radius, widest_pocket(scene)) / grid.cell + blur);
    CellMask off_bed(grid.size());
    for (std::size_t i = 0; i < bed.size(); ++i)
        off_bed[i] = bed[i] == 0;
    const std::vector<float> depth = distance_from(grid, off_bed);
    CellMask broad(grid.size());
    for (std::size_t i = 0; i < bed.size(); ++i)
        broad[i] = depth[i] > half;
    const std::vector<float> apart = distance_from(grid, broad);
    for (std::size_t i = 0; i < bed.size(); ++i)
        jaws[i] = bed[i] != 0 && apart[i] > half + 1.0F;
    return jaws;
}

RailWidths rail_widths(const Scene& scene) {
    const Balls& balls = scene.world.balls();
    const double radius = balls.size() > 0 ? balls.radius.front() : 0.0;
    if (is_pool_table(scene)) {
        const double pocket = widest_pocket(scene);
        const double rail = pocket > 0.0 ? 2.2 * pocket : 4.5 * radius;
        return {rail, 0.36 * rail};
    }
    if (!scene.table.is_empty()) return {1.4 * radius, 0.0};
    const Vec2 extent = size(scene.view);
    return {scene.dress.theme.rail ? 0.03 * std::max(extent.x, extent.y) : 0.0, 0.0};
}

// The width, in cells, of a rail that contains the jaws of the pockets: edges that lead off the
// bed.
double rail_around_jaws(const Scene& scene, const BoardGrid& grid, const std::vector<float>& far,
                        double rail) {
    const double pocket = is_pool_table(scene) ? widest_pocket(scene) / grid.cell : 0.0;
    if (pocket == 0.0) return rail;
    double width = rail;
    for (const Capsule& jaw : scene.world.capsules().shape)
        for (const Vec2 end : {jaw.start, jaw.end})
            width = std::max(width, static_cast<double>(far[grid.index_of(end)]) + 0.5 * pocket);
    return std::min(width, 4.0 * pocket);
}

}  // namespace carom
