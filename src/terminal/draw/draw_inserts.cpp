#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/elementary.h"
#include "geometry/polygon.h"
#include "terminal/canvas/character_width.h"
#include "terminal/canvas/legible.h"
#include "terminal/draw/board_texts.h"
#include "terminal/draw/draw_parts.h"

/// Draws the lights that are set into the board of a pinball table, and their names.
namespace carom {

namespace {

// An unlit insert is translucent plastic: this share of its colour on the board.
constexpr double unlit_share = 0.34;
// Of an unlit insert's name to the board: a player looks for it, so it is lighter than its insert.
constexpr double name_contrast = 0.34;
// The glow around a lit insert, in radii; smaller inserts, in columns, have none.
constexpr double halo_share = 1.4;
constexpr double least_halo = 1.2;

// The corners of a shape of radius 1 that points up, y upwards.
std::vector<Vec2> outline_of(InsertShape shape) {
    switch (shape) {
        case InsertShape::circle:
            return {};
        case InsertShape::arrow:
            return {{0.0, 1.0},    {0.85, 0.1},  {0.35, 0.1}, {0.35, -1.0},
                    {-0.35, -1.0}, {-0.35, 0.1}, {-0.85, 0.1}};
        case InsertShape::triangle:
            return {{0.0, 1.0}, {0.87, -0.6}, {-0.87, -0.6}};
        case InsertShape::square:
            return {{0.8, 0.8}, {0.8, -0.8}, {-0.8, -0.8}, {-0.8, 0.8}};
        case InsertShape::diamond:
            return {{0.0, 1.0}, {0.75, 0.0}, {0.0, -1.0}, {-0.75, 0.0}};
        case InsertShape::bar:
            return {{0.3, 1.0}, {0.3, -1.0}, {-0.3, -1.0}, {-0.3, 1.0}};
        case InsertShape::star: {
            std::vector<Vec2> corners;
            constexpr int points = 5;
            for (int i = 0; i < 2 * points; ++i) {
                const SinCos at = sin_cos_degrees(90.0 + 36.0 * i);
                corners.push_back(Vec2{at.cos, at.sin} * (i % 2 == 0 ? 1.0 : 0.45));
            }
            return corners;
        }
    }
    return {};
}

// In ASCII a light is one character: an arrow where it points, upper case or bold where lit.
std::string_view glyph_of(const TableLight& light) {
    const Vec2 way = light.direction;
    switch (light.insert) {
        case InsertShape::arrow:
        case InsertShape::triangle:
            if (std::abs(way.x) > std::abs(way.y)) return way.x > 0.0 ? ">" : "<";
            return way.y > 0.0 ? "^" : "v";
        case InsertShape::square:
            return light.is_lit ? "#" : "=";
        case InsertShape::diamond:
        case InsertShape::star:
            return light.is_lit ? "*" : "+";
        case InsertShape::bar:
            return std::abs(way.x) > std::abs(way.y) ? "-" : "|";
        case InsertShape::circle:
            return light.is_lit ? "O" : "o";
    }
    return "o";
}

/// The pixels of a shape along one axis.
struct PixelSpan {
    int first = 0;
    int count = 1;
    double middle = 0.0;  ///< in columns
};

// As many as the shape is wide, and as near to it as can be, so that shapes of one size are alike
// wherever they are.
PixelSpan pixel_span(double middle, double radius, double step) {
    constexpr double most = 1e6;
    PixelSpan span;
    span.count = static_cast<int>(std::clamp(std::round(2.0 * radius / step), 1.0, most));
    span.first =
        static_cast<int>(std::clamp(std::round(middle / step - 0.5 * span.count), -most, most));
    span.middle = (span.first + 0.5 * span.count) * step;
    return span;
}

void fill_pixels(Raster& raster, const PixelSpan& columns, const PixelSpan& rows, const Ink& ink,
                 std::uint8_t level) {
    for (int down = std::max(0, rows.first);
         down < std::min(raster.samples_down(), rows.first + rows.count); ++down)
        for (int across = std::max(0, columns.first);
             across < std::min(raster.samples_across(), columns.first + columns.count); ++across)
            raster.sample(across, down, level, ink);
}

void paint_shape(Raster& raster, RasterPoint at, double radius, const TableLight& light,
                 const Ink& ink, std::uint8_t level) {
    if (raster.renderer().has_pixels()) {
        const PixelSpan columns = pixel_span(at.x, radius, 1.0 / raster.renderer().across);
        const PixelSpan rows = pixel_span(at.y, radius, raster.aspect() / raster.renderer().down);
        // So few pixels have no room for another shape than a square.
        constexpr int least_shaped = 4;
        if (std::min(columns.count, rows.count) < least_shaped)
            return fill_pixels(raster, columns, rows, ink, level);
        at = {columns.middle, rows.middle};
    }
    if (light.insert == InsertShape::circle)
        return raster.disc(at, radius, 0.0, {ink, level, '\0'});
    const Vec2 up = light.direction;
    const Vec2 right{up.y, -up.x};
    std::vector<RasterPoint> corners;
    for (const Vec2 corner : outline_of(light.insert)) {
        const Vec2 turned = (right * corner.x + up * corner.y) * radius;
        corners.push_back({at.x + turned.x, at.y - turned.y});
    }
    fill_polygon(raster, corners, ink, level);
}

}  // namespace

void fill_dot(Raster& raster, RasterPoint middle, double radius, const Ink& ink,
              std::uint8_t level) {
    fill_pixels(raster, pixel_span(middle.x, radius, 1.0 / raster.renderer().across),
                pixel_span(middle.y, radius, raster.aspect() / raster.renderer().down), ink, level);
}

void fill_polygon(Raster& raster, std::span<const RasterPoint> corners, const Ink& ink,
                  std::uint8_t level) {
    if (corners.empty()) return;
    RasterPoint low = corners.front();
    RasterPoint high = corners.front();
    for (const RasterPoint corner : corners) {
        if (!std::isfinite(corner.x) || !std::isfinite(corner.y)) return;
        low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
        high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
    }
    const double width = 1.0 / raster.renderer().across;
    const double height = raster.aspect() / raster.renderer().down;
    const auto index = [](double place, double step, int most) {
        return static_cast<int>(std::clamp(place / step, 0.0, static_cast<double>(most)));
    };
    for (int down = index(low.y, height, raster.samples_down());
         down < std::min(raster.samples_down(), index(high.y, height, raster.samples_down()) + 1);
         ++down)
        for (int across = index(low.x, width, raster.samples_across());
             across <
             std::min(raster.samples_across(), index(high.x, width, raster.samples_across()) + 1);
             ++across)
            if (is_inside_polygon(corners, {(across + 0.5) * width, (down + 0.5) * height}))
                raster.sample(across, down, level, ink);
}

// An unlit light lets the board show through, whatever the colour of the screen around it.
Color unlit(Color color, double share, int column, int row, const View& view) {
    return dimmed(color, share, view.memory.ground.behind(column, row), view.options.look);
}

Color unlit_name(Color color, int column, int row, const View& view) {
    constexpr double share = 0.6;
    return legible_on(unlit(color, share, column, row, view),
                      view.memory.ground.behind(column, row), view.options.look, name_contrast);
}

double halo_radius(const View& view, const TableLight& light) {
    const double radius = light.shape.radius * view.camera.columns_per_length;
    return radius >= least_halo ? halo_share * radius : 0.0;
}

void paint_insert(Raster& raster, const View& view, const TableLight& light) {
    const Look& look = view.options.look;
    Ink ink = light.color ? dress_ink(*light.color, look) : ink_of_class(light.family, look);
    const RasterPoint at = to_raster(view.camera, light.shape.start);
    if (raster.renderer().has_regions()) {
        ink.attributes = look.has_colors() ? plain : dim;
        if (light.is_lit) ink = lit_ink(raster, {ink.color, plain}, look);
        const CellPoint cell = to_cells(view.camera, light.shape.start);
        if (!light.is_lit && std::abs(cell.column) < 1e6 && std::abs(cell.row) < 1e6)
            ink.color = unlit(ink.color, 0.5, static_cast<int>(std::floor(cell.column)),
                              static_cast<int>(std::floor(cell.row)), view);
        return raster.stamp(at, glyph_of(light), ink);
    }
    const double radius =
        std::max(light.shape.radius * view.camera.columns_per_length, 1.1 * raster.hairline());
    constexpr std::uint8_t full = 255;
    if (raster.renderer().has_dots() || !look.has_shades()) {
        if (!light.is_lit) return raster.disc(at, 0.0, 0.0, {ink, full, '\0'});
        const double lit_radius = std::max(radius, lit_swell(raster, look));
        return paint_shape(raster, at, lit_radius, light, lit_ink(raster, ink, look), full);
    }
    if (!light.is_lit) {
        const auto level = static_cast<std::uint8_t>(unlit_share * full);
        return paint_shape(raster, at, radius, light, ink, level);
    }
    constexpr std::uint8_t halo = 56;
    if (radius >= least_halo) raster.disc(at, halo_share * radius, 0.0, {ink, halo, '\0'});
    paint_shape(raster, at, radius, light, {tones_of(ink.color, look).light, bold}, full);
}

void write_insert_names(BoardTexts& texts, const View& view) {
    if (!view.annotations.table) return;
    const Look& look = view.options.look;
    for (const TableLight& light : view.annotations.table->lights) {
        if (light.text.empty()) continue;
        const CellPoint at = to_cells(view.camera, light.shape.start);
        if (!(std::abs(at.column) < 1e6 && std::abs(at.row) < 1e6)) continue;
        // Below the light, and below its halo: text is not written over shapes.
        const double radius = light.shape.radius * view.camera.columns_per_length;
        const double rows = radius / view.camera.aspect;
        const int width = columns_of(light.text);
        const int row =
            static_cast<int>(radius >= least_halo ? std::ceil(at.row + halo_share * rows + 0.1)
                                                  : std::floor(at.row + std::max(rows, 0.5) + 0.5));
        const int first = static_cast<int>(std::lround(at.column - 0.5 * width));
        if (texts.covers_light({row, first, first + width})) continue;
        Ink ink = light.color ? dress_ink(*light.color, look) : ink_of_class(light.family, look);
        ink.attributes = light.is_lit ? bold : plain;
        if (!light.is_lit) ink.color = unlit_name(ink.color, first + width / 2, row, view);
        if (!look.has_colors()) ink.attributes = light.is_lit ? bold : dim;
        texts.write(first, row, light.text, ink);
    }
}

}  // namespace carom
