#include "terminal/draw/draw.h"

#include <algorithm>
#include <cmath>

#include "terminal/draw/board_texts.h"
#include "terminal/draw/draw_parts.h"

namespace carom {

namespace {

// Keeps the recent top speed, which scales the colours. It decays slowly, so that colours do not
// flicker.
void remember_fastest(ViewMemory& memory, const World& world) {
    double fastest = 0.0;
    for (const Vec2 velocity : world.balls().velocity) {
        fastest = std::max(fastest, length_squared(velocity));
    }
    const bool has_moved = memory.tick != world.tick();
    memory.tick = world.tick();
    memory.fastest = std::max(std::sqrt(fastest), memory.fastest * (has_moved ? 0.995 : 1.0));
}

// Cells beyond the border of a torus show copies of what is within, so they are darker.
void dim_copies(Canvas& canvas, const View& view) {
    if (!view.world.model().wrap) return;
    const Box& torus = *view.world.model().wrap;
    const Look& look = view.options.look;
    const CellArea& area = view.camera.area;
    constexpr double share = 0.5;
    for (int row = area.row; row < area.row + area.rows; ++row)
        for (int column = area.column; column < area.column + area.columns; ++column) {
            if (!canvas.holds(column, row)) continue;
            if (contains(torus, to_world(view.camera, {column + 0.5, row + 0.5}))) continue;
            Cell& cell = canvas.at(column, row);
            if (cell.glyph == U' ' && cell.background == default_color) continue;
            if (!look.has_shades()) {
                cell.attributes = static_cast<std::uint8_t>((cell.attributes & ~bold) | dim);
                continue;
            }
            cell.foreground =
                dimmed(cell.foreground < 0 ? foreground_color(look) : cell.foreground, share, look);
            cell.background = dimmed(cell.background, share, look);
        }
}

void write_texts(Canvas& canvas, const View& view) {
    write_coordinates(canvas, view);
    if (view.options.counters && !view.annotations.pool && !view.annotations.table)
        write_counters(canvas, view);
    if (view.annotations.pool && view.options.labels == Labels::automatic)
        write_numbers(canvas, view);
    else
        write_labels(canvas, view);
    if (view.options.board_texts) {
        BoardTexts texts(canvas, view);
        write_board_labels(texts, view);
        write_insert_names(texts, view);
    }
    write_scale(canvas, view);
    write_annotations(canvas, view);
}

}  // namespace

const Renderer& renderer_in_force(const ViewOptions& options) {
    // Without colours a ball of dots among dots cannot be seen, a character can.
    const bool wants_characters = options.is_table && !options.look.has_colors();
    if (options.renderer == nullptr && wants_characters) return ascii_renderer();
    return renderer_for(options.renderer, options.look);
}

void draw_world(Canvas& canvas, const Camera& camera, const Scene& scene, const World& world,
                std::span<const Contact> contacts, const Annotations& annotations,
                const ViewOptions& options, ViewMemory& memory) {
    const CellArea& area = camera.area;
    canvas.clear(area);
    if (area.columns <= 0 || area.rows <= 0) return;

    remember_fastest(memory, world);
    note_impacts(memory, world, contacts);
    std::vector<Ink> inks = ball_inks(world, options, memory);
    if (options.color_by == ColorBy::kind) dress_balls(inks, scene, world, options.look);
    memory.ground.update(scene, camera, renderer_in_force(options), options.look);
    if (annotations.pool && options.color_by == ColorBy::kind)
        color_pool_balls(inks, scene, world, *annotations.pool, options.look);
    Raster raster = memory.ground.raster();
    const View view{camera, scene, world, options, annotations, memory, contacts, inks};
    const Board& board = memory.ground.board(scene);
    polish_balls(inks, view, board);

    paint_pool_table(raster, view, board);
    paint_overlays_below(raster, view);
    if (options.trails) {
        add_to_trails(memory.trails, camera, raster, world, inks);
        paint_trails(raster, memory.trails, options.look);
    } else {
        memory.trails = {};
    }
    paint_border(raster, view);
    paint_zones(raster, view);
    paint_lamps(raster, view);
    // A cloud extends beyond its balls, and would hide the walls that they rest on.
    if (!annotations.copies.empty()) paint_cloud(raster, view);
    paint_edges(raster, view, board, Level::board);
    paint_holes(raster, view);
    paint_hinges(raster, view);
    paint_lit_edges(raster, view);
    const bool shows_balls = annotations.copies.empty();
    paint_cradles(raster, view);
    if (shows_balls) paint_shadows(raster, view);
    if (shows_balls) paint_balls(raster, view, Level::board);
    if (has_level_above(view)) {
        paint_areas_above(raster, view);
        paint_edges(raster, view, board, Level::above);
        if (shows_balls) paint_balls(raster, view, Level::above);
    }
    if (shows_balls) paint_flashes(raster, view);
    paint_overlays_above(raster, view);
    paint_pool(raster, view);
    paint_annotations(raster, view);
    raster.show(canvas, area.column, area.row);
    dim_copies(canvas, view);

    write_texts(canvas, view);
    memory.ground.lay(canvas);
}

}  // namespace carom
