#include "terminal/draw/board.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/closest.h"

namespace carom {

namespace {

constexpr int most_cells = 480;  // along the longer side
// A line of cells holds back a flood through sides of cells if it contains every cell whose middle
// is this near to it, in cells.
constexpr double watertight = 0.75;
// Widths of gaps that are closed if the flood reaches a ball, in radii of the ball.
constexpr double gaps[] = {0.0, 1.0, 2.2, 4.0};

struct Grid {
    Box box;
    double cell = 1.0;
    int columns = 0;
    int rows = 0;

    std::size_t size() const {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
    Vec2 middle(int column, int row) const {
        return box.low + Vec2{(column + 0.5) * cell, (row + 0.5) * cell};
    }
    int column_of(double x) const {
        return static_cast<int>(std::clamp((x - box.low.x) / cell, 0.0, columns - 1.0));
    }
    int row_of(double y) const {
        return static_cast<int>(std::clamp((y - box.low.y) / cell, 0.0, rows - 1.0));
    }
    std::size_t index_of(Vec2 place) const { return index(column_of(place.x), row_of(place.y)); }
};

using Mask = std::vector<std::uint8_t>;

// Marks the cells within `radius` of the spine.
void mark(Mask& mask, const Grid& grid, const Capsule& shape, double radius) {
    const Box box = grow(join({shape.start, shape.start}, {shape.end, shape.end}), radius);
    if (!overlaps(box, grid.box)) return;
    for (int row = grid.row_of(box.low.y); row <= grid.row_of(box.high.y); ++row)
        for (int column = grid.column_of(box.low.x); column <= grid.column_of(box.high.x);
             ++column) {
            const Vec2 at = grid.middle(column, row);
            if (distance(closest_point(shape.start, shape.end, at), at) <= radius)
                mask[grid.index(column, row)] = 1;
        }
}

// Cells that edges and sinks cover, each edge `more` thicker than it is. `one_way`: with gates.
Mask walls_of(const Scene& scene, const Grid& grid, double more, bool one_way = true) {
    const Capsules& edges = scene.world.capsules();
    Mask walls(grid.size(), 0);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const std::size_t material = edges.material[i];
        const auto& layers = scene.dress.layers;
        if (material < layers.size() && layers[material] > 0) continue;
        if (!one_way && !edges.side.empty() && edges.side[i] != Side::both) continue;
        const auto moves = [&](const Flipper& flipper) { return flipper.capsule == edges.id[i]; };
        if (std::ranges::any_of(scene.world.flippers(), moves) ||
            moves_by_itself(scene.world, edges.id[i]))
            continue;
        mark(walls, grid, edges.shape[i],
             std::max(edges.shape[i].radius, watertight * grid.cell) + more);
    }
    for (const Zone& zone : scene.world.zones())
        if (zone.effect == Zone::Effect::sink)
            mark(walls, grid, zone.shape, zone.shape.radius + more);
    return walls;
}

// The cells that can be reached from `from` without entering a wall, within so many steps.
Mask reached(const Grid& grid, const Mask& walls, std::vector<std::size_t> from,
             int steps = std::numeric_limits<int>::max()) {
    Mask reached(grid.size(), 0);
    for (const std::size_t cell : from)
        reached[cell] = 1;
    const auto columns = static_cast<std::size_t>(grid.columns);
    std::vector<std::size_t> next;
    for (int step = 0; step < steps && !from.empty(); ++step) {
        next.clear();
        const auto visit = [&](std::size_t cell) {
            if (reached[cell] || walls[cell]) return;
            reached[cell] = 1;
            next.push_back(cell);
        };
        for (const std::size_t cell : from) {
            if (cell % columns > 0) visit(cell - 1);
            if (cell % columns + 1 < columns) visit(cell + 1);
            if (cell >= columns) visit(cell - columns);
            if (cell + columns < grid.size()) visit(cell + columns);
        }
        from.swap(next);
    }
    return reached;
}

std::vector<std::size_t> border_of(const Grid& grid) {
    std::vector<std::size_t> border;
    for (int column = 0; column < grid.columns; ++column)
        for (const int row : {0, grid.rows - 1})
            border.push_back(grid.index(column, row));
    for (int row = 0; row < grid.rows; ++row)
        for (const int column : {0, grid.columns - 1})
            border.push_back(grid.index(column, row));
    return border;
}

std::vector<std::size_t> balls_of(const Scene& scene, const Grid& grid) {
    std::vector<std::size_t> cells;
    for (const Vec2 place : scene.world.balls().position)
        if (contains(grid.box, place)) cells.push_back(grid.index_of(place));
    return cells;
}

// The outside, without the gaps in the walls; empty if it cannot be told from the inside.
Mask outside_of(const Scene& scene, const Grid& grid) {
    const double radius =
        scene.world.balls().size() > 0 ? scene.world.balls().radius.front() : 2.0 * grid.cell;
    const std::vector<std::size_t> balls = balls_of(scene, grid);
    for (const double gap : gaps) {
        const double more = 0.5 * gap * radius;
        const Mask thick = walls_of(scene, grid, more);
        Mask outside = reached(grid, thick, border_of(grid));
        if (std::ranges::any_of(balls, [&](std::size_t cell) { return outside[cell] != 0; }))
            continue;
        if (std::ranges::none_of(outside, [](std::uint8_t cell) { return cell == 0; })) continue;
        if (more == 0.0) return outside;
        // The flood goes on to the true face of the walls, but not through the gaps.
        std::vector<std::size_t> front;
        for (std::size_t i = 0; i < outside.size(); ++i)
            if (outside[i] != 0) front.push_back(i);
        return reached(grid, walls_of(scene, grid, 0.0), front,
                       static_cast<int>(std::ceil(more / grid.cell)));
    }
    return {};
}

// The distance of each cell from the nearest one that is set, in cells, by steps to the eight
// neighbours. A `diagonal` step counts less than it is long, so that corners come out squarer.
std::vector<float> distance_from(const Grid& grid, const Mask& set, float diagonal = 1.2F) {
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
void fill_bites(Mask& bed, const Scene& scene, const Grid& grid) {
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

// The distance from the bed without the mouths of its pockets, so that the frame runs straight.
std::vector<float> distance_from_bed(const Scene& scene, const Grid& grid, const Mask& bed) {
    const double mouth = is_pool_table(scene) ? 1.7 * widest_pocket(scene) / grid.cell : 0.0;
    if (mouth == 0.0) return distance_from(grid, bed);
    Mask off_bed(grid.size());
    for (std::size_t i = 0; i < bed.size(); ++i)
        off_bed[i] = bed[i] == 0;
    const std::vector<float> depth = distance_from(grid, off_bed);
    Mask deep(grid.size());
    for (std::size_t i = 0; i < bed.size(); ++i)
        deep[i] = static_cast<double>(depth[i]) > mouth;
    fill_bites(deep, scene, grid);
    constexpr float square = 1.0F;
    std::vector<float> far = distance_from(grid, deep, square);
    for (float& distance : far)
        distance = std::max(0.0F, distance - static_cast<float>(mouth));
    return far;
}

// Widths of the rail and of its inner part, the cushion, length.
struct RailWidths {
    double rail = 0.0;
    double cushion = 0.0;
};
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
double rail_around_jaws(const Scene& scene, const Grid& grid, const std::vector<float>& far,
                        double rail) {
    const double pocket = is_pool_table(scene) ? widest_pocket(scene) / grid.cell : 0.0;
    if (pocket == 0.0) return rail;
    double width = rail;
    for (const Capsule& jaw : scene.world.capsules().shape)
        for (const Vec2 end : {jaw.start, jaw.end})
            width = std::max(width, static_cast<double>(far[grid.index_of(end)]) + 0.5 * pocket);
    return std::min(width, 4.0 * pocket);
}

bool wants_board(const Scene& scene) {
    return is_pool_table(scene) || !scene.table.is_empty() || scene.dress.theme.board ||
           scene.dress.theme.rail;
}

}  // namespace

bool is_pool_table(const Scene& scene) {
    return scene.pool.cue || !scene.pool.pockets.empty();
}

Board::Board(const Scene& scene) {
    if (wants_board(scene)) flood(scene);
}

void Board::flood(const Scene& scene) {
    const RailWidths widths = rail_widths(scene);
    Box box = scene.view;
    for (const std::uint32_t pocket : scene.pool.pockets)
        box = join(box, bounds(scene.world.zones()[pocket].shape));
    for (const Capsule& shape : scene.world.capsules().shape)
        box = join(box, bounds(shape));
    const double longest = std::max(size(box).x, size(box).y) + 2.0 * widths.rail;
    if (!std::isfinite(longest) || !(longest > 0.0)) return;
    Grid grid;
    grid.cell = longest / most_cells;
    grid.box = grow(box, widths.rail + 4.0 * grid.cell);
    grid.columns = static_cast<int>(std::ceil(size(grid.box).x / grid.cell));
    grid.rows = static_cast<int>(std::ceil(size(grid.box).y / grid.cell));

    const Mask outside = outside_of(scene, grid);
    if (outside.empty()) return;
    // The frame is measured from the bed: pockets lie within it.
    Mask bed(grid.size(), 0);
    for (std::size_t i = 0; i < bed.size(); ++i)
        bed[i] = outside[i] == 0;
    Mask pockets(grid.size(), 0);
    for (const std::uint32_t pocket : scene.pool.pockets) {
        const Capsule& shape = scene.world.zones()[pocket].shape;
        mark(pockets, grid, shape, shape.radius);
    }
    for (std::size_t i = 0; i < bed.size(); ++i)
        if (pockets[i] != 0) bed[i] = 0;
    const std::vector<float> far = distance_from_bed(scene, grid, bed);
    const auto rail =
        static_cast<float>(rail_around_jaws(scene, grid, far, widths.rail / grid.cell));
    const auto cushion = static_cast<float>(widths.cushion / grid.cell);
    const bool has_plastics = !scene.table.is_empty();
    const Mask walls = has_plastics ? walls_of(scene, grid, 0.0, false) : Mask(grid.size(), 0);
    const Mask open = has_plastics ? reached(grid, walls, balls_of(scene, grid)) : walls;

    cells_.assign(grid.size(), Ground::none);
    Box frame{grid.box.high, grid.box.low};
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const std::size_t i = grid.index(column, row);
            Ground& ground = cells_[i];
            if (bed[i] != 0)
                ground =
                    has_plastics && open[i] == 0 && walls[i] == 0 ? Ground::plastic : Ground::board;
            else if (far[i] <= cushion)
                ground = Ground::cushion;
            else if (far[i] <= rail)
                ground = Ground::rail;
            if (ground == Ground::none) continue;
            const Vec2 at = grid.middle(column, row);
            frame = {{std::min(frame.low.x, at.x), std::min(frame.low.y, at.y)},
                     {std::max(frame.high.x, at.x), std::max(frame.high.y, at.y)}};
        }
    frame_ = grow(frame, 0.5 * grid.cell);
    box_ = grid.box;
    cell_ = grid.cell;
    columns_ = grid.columns;
    rows_ = grid.rows;
}

Ground Board::at(Vec2 place) const {
    const double column = (place.x - box_.low.x) / cell_;
    const double row = (place.y - box_.low.y) / cell_;
    if (!(column >= 0.0 && column < columns_ && row >= 0.0 && row < rows_)) return Ground::none;
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
}

Box shown_box(const Scene& scene, const Board& board) {
    return board.is_empty() ? scene.view : join(scene.view, board.frame());
}

}  // namespace carom
