#include "terminal/draw/board_rail.h"

#include <algorithm>
#include <utility>

#include "terminal/draw/board.h"

namespace carom {

namespace {

// The distance of each cell from the nearest one that is set, in cells, by steps to the eight
// neighbours. A `diagonal` step counts less than it is long, so that corners come out squarer.
std::vector<float> distance_from(const BoardGrid& grid, const CellMask& set,
                                 float diagonal = 1.2F) {
    std::vector<float> distance(grid.size(), 1e9F);
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set[i] != 0) distance[i] = 0.0F;
    const auto relax = [&](int column, int row, int dx, int dy) {
        if (column + dx < 0 || column + dx >= grid.columns || row + dy < 0 || row + dy >= grid.rows)
            return;
        float& mine = distance[grid.index(column, row)];
        const float step = dx != 0 && dy != 0 ? diagonal : 1.0F;
        mine = std::min(mine, distance[grid.index(column + dx, row + dy)] + step);
    };
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            for (const auto& [dx, dy] : {std::pair{-1, 0}, {-1, -1}, {0, -1}, {1, -1}})
                relax(column, row, dx, dy);
    for (int row = grid.rows - 1; row >= 0; --row)
        for (int column = grid.columns - 1; column >= 0; --column)
            for (const auto& [dx, dy] : {std::pair{1, 0}, {1, 1}, {0, 1}, {-1, 1}})
                relax(column, row, dx, dy);
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
