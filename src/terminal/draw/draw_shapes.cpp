#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "terminal/draw/board.h"
#include "terminal/draw/draw_parts.h"

/// Draws edges and zones, and the level above the board.
namespace carom {

namespace {

Level level_of_edge(const View& view, std::size_t edge) {
    const auto& layers = view.scene.dress.layers;
    const std::size_t material = view.world.capsules().material[edge];
    return material < layers.size() && layers[material] > 0 ? Level::above : Level::board;
}

// What lies above the board throws a shadow on it, to the lower right.
void paint_shadow(Raster& raster, const View& view, const Capsule& shape) {
    if (!raster.renderer().has_pixels() || !view.options.look.has_shades()) return;
    constexpr double right = 1.0;  // columns
    constexpr double down = 1.2;
    constexpr std::uint8_t tone = 110;
    const RasterPoint start = to_raster(view.camera, shape.start);
    const RasterPoint end = to_raster(view.camera, shape.end);
    raster.capsule({start.x + right, start.y + down}, {end.x + right, end.y + down},
                   shape.radius * view.camera.columns_per_length,
                   {dress_ink(0, view.options.look), tone, '\0'});
}

}  // namespace

bool has_level_above(const View& view) {
    const auto is_above = [](std::uint8_t layer) { return layer > 0; };
    return std::ranges::any_of(view.scene.dress.layers, is_above) ||
           std::ranges::any_of(view.scene.dress.areas, is_above, &PaintedArea::layer);
}

void paint_areas_above(Raster& raster, const View& view) {
    constexpr std::uint8_t see_through = 105;
    if (!raster.renderer().has_pixels() || !view.options.look.has_shades()) return;
    for (const PaintedArea& area : view.scene.dress.areas) {
        if (area.layer == 0) continue;
        const Ink ink = dress_ink(area.color, view.options.look);
        if (area.corners.empty()) {
            raster.disc(to_raster(view.camera, area.disc.center),
                        area.disc.radius * view.camera.columns_per_length, 0.0,
                        {ink, see_through, '\0'});
            continue;
        }
        std::vector<RasterPoint> corners;
        for (const Vec2 corner : area.corners)
            corners.push_back(to_raster(view.camera, corner));
        fill_polygon(raster, corners, ink, see_through);
    }
}

RasterPoint to_raster(const Camera& camera, Vec2 point) {
    const CellPoint place = to_cells(camera, point);
    return {place.column - camera.area.column, (place.row - camera.area.row) * camera.aspect};
}

Images images_of(const Model& model, const Box& bounds, const Camera& camera) {
    Images images;
    images.count = 1;  // the body itself
    if (!model.wrap) return images;
    const Box visible = visible_box(camera);
    const Vec2 period = size(*model.wrap);
    for (const int across : {0, -1, 1}) {
        for (const int up : {0, -1, 1}) {
            const Vec2 offset{across * period.x, up * period.y};
            const bool is_seen = overlaps({bounds.low + offset, bounds.high + offset}, visible);
            const bool is_itself = across == 0 && up == 0;
            if (is_seen && !is_itself) images.offsets[images.count++] = offset;
        }
    }
    return images;
}

std::vector<Ink> ball_inks(const World& world, const ViewOptions& options,
                           const ViewMemory& memory) {
    const Balls& balls = world.balls();
    std::vector<Ink> inks(balls.size());
    const auto each = [&](auto ink_of_ball) {
        for (std::size_t i = 0; i < balls.size(); ++i)
            inks[i] = ink_of_ball(i);
    };
    const auto are_of_one_kind = [&] {
        return std::ranges::adjacent_find(balls.kind, std::not_equal_to{}) == balls.kind.end();
    };
    const bool is_by_kind = options.color_by == ColorBy::kind;
    switch (is_by_kind && are_of_one_kind() ? ColorBy::ball : options.color_by) {
        case ColorBy::kind:
            each([&](std::size_t i) { return ink_of_class(balls.kind[i], options.look); });
            break;
        case ColorBy::ball:
            each([&](std::size_t i) { return ink_of_class(number(balls.id[i]), options.look); });
            break;
        case ColorBy::speed: {
            const double scale = memory.fastest > 0.0 ? 1.0 / memory.fastest : 0.0;
            each([&](std::size_t i) {
                return ink_of_scale(length(balls.velocity[i]) * scale, options.look);
            });
            break;
        }
        case ColorBy::mass: {
            if (balls.size() == 0) break;
            // Logarithmic: masses may span many powers of ten.
            const auto [least, most] =
                std::minmax_element(balls.inverse_mass.begin(), balls.inverse_mass.end());
            const double heaviest = *least;
            const double range = std::log(*most / heaviest);
            each([&](std::size_t i) {
                const double lightness = std::log(balls.inverse_mass[i] / heaviest);
                return ink_of_scale(range > 0.0 ? 1.0 - lightness / range : 0.5, options.look);
            });
            break;
        }
    }
    return inks;
}

void paint_border(Raster& raster, const View& view) {
    if (!view.world.model().wrap) return;
    const Box& torus = *view.world.model().wrap;
    const Ink ink = ink_of(Role::grid, view.options.look);
    const auto side = [&](Vec2 from, Vec2 to) {
        raster.line(to_raster(view.camera, from), to_raster(view.camera, to), ink);
    };
    const Box visible = visible_box(view.camera);
    const double column = 1.0 / view.camera.columns_per_length;
    // The margin of a fitted view shows nothing that needs a border.
    if (visible.high.x - torus.high.x > column || torus.low.x - visible.low.x > column) {
        side(torus.low, {torus.low.x, torus.high.y});
        side({torus.high.x, torus.low.y}, torus.high);
    }
    const double row = view.camera.aspect * column;
    if (visible.high.y - torus.high.y > row || torus.low.y - visible.low.y > row) {
        side(torus.low, {torus.high.x, torus.low.y});
        side({torus.low.x, torus.high.y}, torus.high);
    }
}

void paint_zones(Raster& raster, const View& view) {
    const Ink plain_ink = ink_of(Role::zone, view.options.look);
    const double rim = 2.0 * raster.hairline();
    for (std::size_t i = 0; i < view.world.zones().size(); ++i) {
        const Zone& zone = view.world.zones()[i];
        // Walls show where a counting zone is; a sink has none, and must be seen.
        if (zone.effect != Zone::Effect::sink) continue;
        if (paint_pocket(raster, view, i)) continue;
        const RasterPoint start = to_raster(view.camera, zone.shape.start);
        const RasterPoint end = to_raster(view.camera, zone.shape.end);
        const double radius = zone.shape.radius * view.camera.columns_per_length;
        const auto color = color_in(view.scene.dress.zones, i);
        if (color && view.memory.ground.has_sinks()) continue;
        const Ink ink = color ? dress_ink(*color, view.options.look) : plain_ink;
        raster.capsule(start, end, radius, {ink, 120, '\0'});
        // One with a colour of its own is filled, as a pond is: clearing it would clear the board.
        if (!color && radius > 2.0 * rim) raster.capsule(start, end, radius - rim, {ink, 0, '\0'});
    }
}

namespace {

// The part of a jaw before the rail, whose wood lies above it; none where all is under the wood.
std::optional<Capsule> before_rail(Capsule jaw, const Board& board) {
    constexpr int steps = 32;
    if (board.at(jaw.start) == Ground::rail) std::swap(jaw.start, jaw.end);
    const Vec2 way = (jaw.end - jaw.start) / steps;
    int seen = 0;
    while (seen <= steps && board.at(jaw.start + way * seen) != Ground::rail)
        ++seen;
    if (seen == 0) return std::nullopt;
    jaw.end = jaw.start + way * (seen - 1);
    return jaw;
}

}  // namespace

void paint_edges(Raster& raster, const View& view, const Board& board, Level level) {
    const bool has_wood = paints_tables(raster, view) && is_pool_table(view.scene);
    const Capsules& edges = view.world.capsules();
    const Box visible = visible_box(view.camera);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (!edges.side.empty() && edges.side[i] == Side::none) continue;
        if (level_of_edge(view, i) != level) continue;
        const auto seen = has_wood ? before_rail(edges.shape[i], board) : edges.shape[i];
        if (!seen) continue;
        const Capsule& shape = *seen;
        const bool is_selected = view.annotations.selected_capsule == edges.id[i];
        const Ink ink = is_selected ? ink_of(Role::selected, view.options.look) : edge_ink(view, i);
        const double radius = shape.radius * view.camera.columns_per_length;
        const double hair = raster.hairline() / view.camera.columns_per_length;
        for (const Vec2 offset : images_of(view.world.model(), bounds(shape), view.camera)) {
            const Capsule image{shape.start + offset, shape.end + offset, shape.radius};
            if (!overlaps(grow(bounds(image), hair), visible)) continue;
            const RasterPoint start = to_raster(view.camera, image.start);
            const bool is_peg = edges.shape[i].start == edges.shape[i].end;
            const Brush brush{ink, 255, '#'};
            if (level == Level::above) paint_shadow(raster, view, image);
            if (is_peg) {
                paint_peg(raster, start, radius, brush);
            } else {
                raster.capsule(start, to_raster(view.camera, image.end), radius, brush);
            }
        }
    }
}

void paint_hinges(Raster& raster, const View& view) {
    const Ink ink = ink_of(Role::strong, view.options.look);
    for (const Seesaw& seesaw : view.world.seesaws()) {
        const double radius = 1.2 * seesaw.home.radius * view.camera.columns_per_length;
        const double least = 1.5 * raster.hairline();
        raster.disc(to_raster(view.camera, seesaw.pivot), std::max(radius, least), 0.0,
                    {ink, 255, 'o'});
    }
}

}  // namespace carom
