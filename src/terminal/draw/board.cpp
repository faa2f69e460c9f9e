#include "terminal/draw/board.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/closest.h"
#include "terminal/draw/board_rail.h"

namespace carom {

namespace {

constexpr int most_cells = 480;  // along the longer side
// A line of cells holds back a flood through sides of cells if it contains every cell whose middle
// is this near to it, in cells.
constexpr double watertight = 0.75;
// Widths of gaps that are closed if the flood reaches a ball, in radii of the ball.
constexpr double gaps[] = {0.0, 1.0, 2.2, 4.0};

// Marks the cells within `radius` of the spine.
void mark(CellMask& mask, const BoardGrid& grid, const Capsule& shape, double radius) {
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
CellMask walls_of(const Scene& scene, const BoardGrid& grid, double more, bool one_way = true) {
    const Capsules& edges = scene.world.capsules();
    CellMask walls(grid.size(), 0);
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
CellMask reached(const BoardGrid& grid, const CellMask& walls, std::vector<std::size_t> from,
                 int steps = std::numeric_limits<int>::max()) {
    CellMask reached(grid.size(), 0);
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

std::vector<std::size_t> border_of(const BoardGrid& grid) {
    std::vector<std::size_t> border;
    for (int column = 0; column < grid.columns; ++column)
        for (const int row : {0, grid.rows - 1})
            border.push_back(grid.index(column, row));
    for (int row = 0; row < grid.rows; ++row)
        for (const int column : {0, grid.columns - 1})
            border.push_back(grid.index(column, row));
    return border;
}

std::vector<std::size_t> balls_of(const Scene& scene, const BoardGrid& grid) {
    std::vector<std::size_t> cells;
    for (const Vec2 place : scene.world.balls().position)
        if (contains(grid.box, place)) cells.push_back(grid.index_of(place));
    return cells;
}

// The outside, without the gaps in the walls; empty if it cannot be told from the inside.
CellMask outside_of(const Scene& scene, const BoardGrid& grid) {
    const double radius =
        scene.world.balls().size() > 0 ? scene.world.balls().radius.front() : 2.0 * grid.cell;
    const std::vector<std::size_t> balls = balls_of(scene, grid);
    for (const double gap : gaps) {
        const double more = 0.5 * gap * radius;
        const CellMask thick = walls_of(scene, grid, more);
        CellMask outside = reached(grid, thick, border_of(grid));
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

// A grid around everything that a board may cover; none where nothing has a size.
std::optional<BoardGrid> grid_around(const Scene& scene, double rail) {
    Box box = scene.view;
    for (const std::uint32_t pocket : scene.pool.pockets)
        box = join(box, bounds(scene.world.zones()[pocket].shape));
    for (const Capsule& shape : scene.world.capsules().shape)
        box = join(box, bounds(shape));
    const double longest = std::max(size(box).x, size(box).y) + 2.0 * rail;
    if (!std::isfinite(longest) || !(longest > 0.0)) return std::nullopt;
    BoardGrid grid;
    grid.cell = longest / most_cells;
    grid.box = grow(box, rail + 4.0 * grid.cell);
    grid.columns = static_cast<int>(std::ceil(size(grid.box).x / grid.cell));
    grid.rows = static_cast<int>(std::ceil(size(grid.box).y / grid.cell));
    return grid;
}

// The inside without the pockets: the frame is measured from it, and pockets lie within the frame.
CellMask bed_of(const Scene& scene, const BoardGrid& grid, const CellMask& outside) {
    CellMask bed(grid.size(), 0);
    for (std::size_t i = 0; i < bed.size(); ++i)
        bed[i] = outside[i] == 0;
    CellMask pockets(grid.size(), 0);
    for (const std::uint32_t pocket : scene.pool.pockets) {
        const Capsule& shape = scene.world.zones()[pocket].shape;
        mark(pockets, grid, shape, shape.radius);
    }
    for (std::size_t i = 0; i < bed.size(); ++i)
        if (pockets[i] != 0) bed[i] = 0;
    return bed;
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
    const std::optional<BoardGrid> around = grid_around(scene, widths.rail);
    if (!around) return;
    const BoardGrid& grid = *around;
    const CellMask outside = outside_of(scene, grid);
    if (outside.empty()) return;
    const CellMask bed = bed_of(scene, grid, outside);
    const std::vector<float> far = distance_from_bed(scene, grid, bed);
    const auto rail =
        static_cast<float>(rail_around_jaws(scene, grid, far, widths.rail / grid.cell));
    const auto cushion = static_cast<float>(widths.cushion / grid.cell);
    const CellMask jaws = jaws_of(scene, grid, bed);
    const bool has_plastics = !scene.table.is_empty();
    const CellMask walls =
        has_plastics ? walls_of(scene, grid, 0.0, false) : CellMask(grid.size(), 0);
    const CellMask open = has_plastics ? reached(grid, walls, balls_of(scene, grid)) : walls;

    cells_.assign(grid.size(), Ground::none);
    Box frame{grid.box.high, grid.box.low};
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const std::size_t i = grid.index(column, row);
            Ground& ground = cells_[i];
            // Wood covers the jaws of pockets from the cushions' depth on.
            if (bed[i] != 0 && !(jaws[i] != 0 && far[i] > cushion))
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
