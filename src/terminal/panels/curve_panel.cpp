#include "terminal/panels/curve_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "terminal/canvas/character_width.h"
#include "terminal/canvas/raster.h"
#include "terminal/panels/panel.h"

namespace carom {
namespace {

constexpr int least_curve_columns = 16;
constexpr int least_curve_rows = 4;

using Points = std::vector<CurvePicture::Point>;

struct Span {
    double low = 0.0;
    double high = 0.0;

    void include(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    double share_of(double value) const { return (value - low) / (high - low); }
};

Points finite_points(const Points& all) {
    Points points;
    for (const CurvePicture::Point& point : all)
        if (std::isfinite(point.x) && std::isfinite(point.y)) points.push_back(point);
    return points;
}

Span span_of_values(const Points& points) {
    Span span;
    for (const CurvePicture::Point& point : points) {
        span.include(point.y);
        if (point.expected) span.include(*point.expected);
    }
    if (!(span.high > span.low)) span.high = span.low + 1.0;
    return span;
}

// A value at an axis, to a hundredth of what the axis spans: more digits than a reader sees.
std::string axis_number(double value, const Span& span) {
    const double step = std::pow(10.0, std::floor(std::log10(span.high - span.low)) - 2.0);
    const double rounded = std::round(value / step) * step;
    return fmt::format("{:.4g}", std::abs(rounded) < 0.5 * step ? 0.0 : rounded);
}

bool is_mostly_bar(char32_t glyph) {
    return std::u32string_view(U"▄▅▆▇█").find(glyph) != std::u32string_view::npos;
}

// The curve's characters, on the ground of the bar that they lie on: a bar goes on behind them.
void lay_over_bars(Canvas& canvas, const CellArea& area, const Raster& raster) {
    Canvas curve(area.columns, area.rows);
    raster.show(curve, 0, 0);
    for (int row = 0; row < area.rows; ++row)
        for (int column = 0; column < area.columns; ++column) {
            Cell cell = curve.at(column, row);
            if (cell == Cell{}) continue;
            const Cell& behind = canvas.at(area.column + column, area.row + row);
            if (is_mostly_bar(behind.glyph)) {
                cell.background = behind.foreground;
                if (behind.foreground == default_color) cell.attributes |= reverse;
            }
            canvas.put(area.column + column, area.row + row, cell);
        }
}

void draw_points(Canvas& canvas, const CellArea& area, const Points& points, const Span& x,
                 const Span& y, bool has_bars, const Look& look) {
    constexpr double aspect = 2.0;
    Raster raster(look.utf8 ? braille_renderer() : ascii_renderer(), area.columns, area.rows,
                  aspect, look);
    const double height = raster.rows() * aspect;
    const auto place = [&](double at, double value) {
        // Slightly inside, so that neither end of the range is cut off.
        return RasterPoint{x.share_of(at) * (area.columns - 0.5),
                           height - 0.4 - y.share_of(value) * (height - 0.8)};
    };
    const Ink expected = ink_of(Role::expected, look);
    const Ink measured = ink_of_class(1, look);
    for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i - 1].expected && points[i].expected)
            raster.line(place(points[i - 1].x, *points[i - 1].expected),
                        place(points[i].x, *points[i].expected), expected);
    for (std::size_t i = 1; i < points.size() && !has_bars; ++i)
        raster.line(place(points[i - 1].x, points[i - 1].y), place(points[i].x, points[i].y),
                    measured);
    lay_over_bars(canvas, area, raster);
}

// The top of a bar. `share`: the filled part of its cell, 0 to 1.
char32_t block_of(double share, const Look& look) {
    constexpr std::u32string_view blocks = U" ▁▂▃▄▅▆▇█";
    constexpr std::u32string_view characters = U" .:#";
    const std::u32string_view all = look.utf8 ? blocks : characters;
    const auto steps = static_cast<double>(all.size() - 1);
    return all[static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * steps + 0.5)];
}

// A bar in each column, as high as the point nearest to it.
void draw_bars(Canvas& canvas, const CellArea& area, const Points& points, const Span& x,
               const Span& y, const Look& look) {
    const Ink ink = ink_of_class(1, look);
    std::size_t nearest = 0;
    for (int column = 0; column < area.columns; ++column) {
        const double at = x.low + (x.high - x.low) * (column + 0.5) / area.columns;
        while (nearest + 1 < points.size() &&
               std::abs(points[nearest + 1].x - at) <= std::abs(points[nearest].x - at))
            ++nearest;
        const double height = y.share_of(points[nearest].y) * area.rows;
        for (int up = 0; up < area.rows && height > up; ++up) {
            const char32_t glyph = block_of(height - up, look);
            if (glyph == U' ') continue;
            // Blocks leave seams in many fonts: a full cell has its colour as the ground too.
            const bool is_full = glyph == U'█' && look.has_colors();
            canvas.put(area.column + column, area.row + area.rows - 1 - up,
                       {glyph, ink.color, is_full ? ink.color : default_color, ink.attributes});
        }
    }
}

}  // namespace

void draw_curve(Canvas& canvas, const CellArea& area, const CurvePicture& picture,
                const Look& look) {
    if (area.columns < least_curve_columns || area.rows < least_curve_rows) return;
    canvas.clear(area);
    std::vector<PanelText> head = {{picture.title, ink_of(Role::strong, look)}};
    if (!picture.value.empty()) head.push_back({picture.value, ink_of(Role::text, look)});
    write_flowing(canvas, {area.column, area.row, area.columns, 1}, head);
    const Points points = finite_points(picture.points);
    if (points.size() < 2 || !(points.back().x > points.front().x)) return;

    const Span x{points.front().x, points.back().x};
    const Span y = span_of_values(points);
    const CellArea inside = draw_axes(canvas, area,
                                      {axis_number(y.low, y), axis_number(y.high, y),
                                       axis_number(x.low, x), axis_number(x.high, x)},
                                      look);
    if (picture.has_bars) draw_bars(canvas, inside, points, x, y, look);
    draw_points(canvas, inside, points, x, y, picture.has_bars, look);
}

}  // namespace carom
