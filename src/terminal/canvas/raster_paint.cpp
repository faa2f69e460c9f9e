#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "terminal/canvas/raster.h"

/// Paints discs and capsules onto a raster: coverage is computed from the signed distance.
namespace carom {

namespace {

// The covered share of a sample whose centre lies `depth` sample widths inside a straight border.
double covered(double depth) {
    return std::clamp(depth + 0.5, 0.0, 1.0);
}

// The distance from x to the interval from a to b.
double distance_to(double x, double a, double b) {
    return std::max({0.0, a - x, x - b});
}

double middle_of_sample(double x, double width) {
    return (std::floor(x / width) + 0.5) * width;
}

bool is_finite(RasterPoint p) {
    return std::isfinite(p.x) && std::isfinite(p.y);
}

// The share of a pixel that a shape must cover to have it, where borders are sharp.
constexpr double least_cover = 0.5;

// Renderers with regions: half the width of the widest capsule that is a line of characters, in
// columns, and the tone from which that line is not dotted.
constexpr double widest_line = 0.8;
constexpr std::uint8_t least_strong = 128;

// How a shape covers a sample: the covered share, and the part of it that is inside the rim.
struct Cover {
    double outer = 0.0;
    double inner = 0.0;
};

}  // namespace

// The filter width for a border with normal (dx, dy): the width over which it crosses a sample.
double Raster::filter_width(double dx, double dy, double distance) const {
    if (distance < 1e-9) return std::max(width_, height_);
    return (width_ * std::abs(dx) + height_ * std::abs(dy)) / distance;
}

template <class Coverage>
void Raster::paint_pixels(CellSamples& cell, RasterPoint corner, const Brush& brush,
                          Coverage coverage) {
    const auto count = static_cast<std::size_t>(renderer_->across * renderer_->down);
    const auto sharpened = [&](double cover) {
        return is_sharp_ || brush.is_crisp ? (cover >= least_cover ? 1.0 : 0.0) : cover;
    };
    for (std::size_t i = 0; i < count; ++i) {
        const Cover cover = coverage(corner.x + middles_[i].x, corner.y + middles_[i].y);
        if (cover.outer <= 0.0) continue;
        const double outer = sharpened(cover.outer);
        const double inner = std::min(outer, sharpened(cover.inner));
        const bool clears = brush.tone == 0 && !brush.is_ring && inner >= 0.5;
        if (clears) {
            cell.levels[i] = 0;
            cell.grounds[i] = default_color;
        }
        blend(cell, i, brush.ink, outer - inner + brush.tone / 255.0 * inner);
    }
}

template <class Coverage>
void Raster::paint_cell(int column, int row, const Brush& brush, Coverage coverage) {
    CellSamples& cell = cell_at(column, row);
    const RasterPoint corner{static_cast<double>(column), row * aspect_};
    if (renderer_->has_pixels()) return paint_pixels(cell, corner, brush, coverage);
    const auto count = static_cast<std::size_t>(renderer_->across * renderer_->down);
    double mine = 0.0;
    double theirs = 0.0;  // what remains of the earlier shapes
    bool is_all_inside = true;
    bool is_touched = false;
    for (std::size_t i = 0; i < count; ++i) {
        const Cover cover = coverage(corner.x + middles_[i].x, corner.y + middles_[i].y);
        // Two opaque shapes of one colour merge: the pieces of a polyline do not add up where they
        // overlap.
        const bool is_one = brush.tone == 255 && cell.colors[0] == brush.ink.color;
        if (cover.outer > 0.0) {
            is_touched = true;
            const int tone = tone_of_sample(brush.tone, static_cast<int>(i));
            const double added = 255.0 * (cover.outer - cover.inner) + tone * cover.inner;
            const double left = cell.levels[i] * (1.0 - cover.outer);
            const double level = is_one ? std::max<double>(cell.levels[i], added) : added + left;
            cell.levels[i] = static_cast<std::uint8_t>(std::min(255.0, level + 0.5));
            mine += 255.0 * cover.outer;
            theirs += left;
        } else {
            theirs += cell.levels[i];
        }
        is_all_inside = is_all_inside && (is_one ? cell.levels[i] == 255 : cover.inner >= 1.0);
    }
    if (!is_touched) return;
    constexpr double most_lined = 0.4;  // the covered share of a cell that still shows its lines
    if (mine > most_lined * 255.0 * static_cast<double>(count)) erase_line(column, row);
    if (mine > 0.0 && mine >= theirs) {
        cell.colors[0] = brush.ink.color;
        cell.attributes[0] = brush.ink.attributes;
    }
    // A solid shape has few borders to look at: most of a cell is all of it.
    constexpr double mostly = 0.45;
    const bool is_solid = brush.tone == 255 && renderer_->has_regions() &&
                          mine > mostly * 255.0 * static_cast<double>(count);
    cell.fill = is_all_inside || is_solid ? brush.fill : '\0';
}

template <class SpanAt, class Inside, class Coverage>
void Raster::paint_rows(double top, double bottom, const Brush& brush, SpanAt span_at,
                        Inside inside, Coverage coverage) {
    const double most = rows_;
    const int first = static_cast<int>(std::floor(std::clamp(top / aspect_, 0.0, most)));
    const int last = static_cast<int>(std::ceil(std::clamp(bottom / aspect_, 0.0, most))) - 1;
    for (int row = first; row <= last; ++row) {
        const Span span = span_at(row * aspect_, (row + 1) * aspect_);
        for (int column = span.first; column <= span.last; ++column) {
            if (inside(column + 0.5, (row + 0.5) * aspect_)) {
                fill_cell(cell_at(column, row), brush);
                erase_line(column, row);
            } else {
                paint_cell(column, row, brush, coverage);
            }
        }
    }
}

void Raster::disc(RasterPoint center, double radius, double rim, const Brush& painted) {
    if (!is_finite(center) || !std::isfinite(radius) || radius < 0.0) return;
    Brush brush = painted;
    brush.ink = visible(painted.ink);
    brush.is_ring = rim > 0.0;
    if (radius < 0.7 * std::min(width_, height_)) {
        if (center.x < 0.0 || center.y < 0.0 || center.x >= columns_ ||
            center.y >= rows_ * aspect_) {
            return;
        }
        const int across = std::min(static_cast<int>(center.x / width_), samples_across() - 1);
        int down = std::min(static_cast<int>(center.y / height_), samples_down() - 1);
        // Two characters show where a dot is: a point above, and one below.
        if (renderer_->has_regions())
            down = static_cast<int>(center.y / aspect_) * renderer_->down +
                   (std::fmod(center.y, aspect_) < 0.5 * aspect_ ? 0 : renderer_->down - 1);
        const double area = 3.14159 * radius * radius / (width_ * height_);
        const double opacity = std::clamp(area, renderer_->level_of_dot, 1.0);
        if (renderer_->has_pixels() && look_.has_shades())
            return sample(across, down, static_cast<std::uint8_t>(255 * opacity), brush.ink);
        const int level = level_at(across, down);
        sample(across, down, static_cast<std::uint8_t>(level + (255 - level) * opacity), brush.ink);
        return;
    }
    // The distance from the border beyond which all corners of a cell are clear of it.
    const double clearance = std::max(width_, height_);
    const double reach = radius + clearance;
    const double inner = radius - rim;
    const double deep = std::max(0.0, inner - clearance);
    const auto span_at = [&](double top, double bottom) {
        const double dy = distance_to(center.y, top, bottom);
        if (dy >= reach) return Span{};
        const double half = std::sqrt(reach * reach - dy * dy);
        return columns_within(center.x - half, center.x + half);
    };
    const auto inside = [&](double x, double y) {
        const double dx = std::abs(x - center.x) + 0.5;
        const double dy = std::abs(y - center.y) + 0.5 * aspect_;
        return dx * dx + dy * dy < deep * deep;
    };
    const auto coverage = [&](double x, double y) -> Cover {
        const double dx = x - center.x;
        const double dy = y - center.y;
        const double squared = dx * dx + dy * dy;
        if (squared > reach * reach) return {};
        const double d = std::sqrt(squared);
        const double width = filter_width(dx, dy, d);
        const double far = covered((d + radius) / width);
        return {far - covered((d - radius) / width),
                inner > 0.0 ? covered((d + inner) / width) - covered((d - inner) / width) : 0.0};
    };
    paint_rows(center.y - reach, center.y + reach, brush, span_at, inside, coverage);
}

// Where borders are sharp, a line as thin as a pixel lights one pixel in each column or row that it
// crosses: it is equally thick everywhere, and has no gaps.
void Raster::thin_line(RasterPoint start, RasterPoint end, const Brush& brush) {
    struct Axes {
        double along = 0.0;
        double across = 0.0;
    };
    const RasterPoint a{start.x / width_, start.y / height_};
    const RasterPoint b{end.x / width_, end.y / height_};
    const bool is_flat = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
    const auto axes = [&](RasterPoint p) { return is_flat ? Axes{p.x, p.y} : Axes{p.y, p.x}; };
    Axes from = axes(a);
    Axes to = axes(b);
    if (from.along > to.along) std::swap(from, to);
    const double slope =
        to.along > from.along ? (to.across - from.across) / (to.along - from.along) : 0.0;
    const double most = is_flat ? samples_across() : samples_down();
    const double most_across = is_flat ? samples_down() : samples_across();
    if (!(from.along < most && to.along >= 0.0)) return;
    const int first = static_cast<int>(std::max(0.0, std::floor(from.along)));
    const int last = static_cast<int>(std::min(most - 1.0, std::floor(to.along)));
    for (int i = first; i <= last; ++i) {
        const double at = std::clamp(i + 0.5, from.along, to.along);
        const double across = from.across + (at - from.along) * slope;
        if (!(across >= 0.0 && across < most_across)) continue;
        const int column = is_flat ? i : static_cast<int>(across);
        const int row = is_flat ? static_cast<int>(across) : i;
        CellSamples& cell = cell_at(column / renderer_->across, row / renderer_->down);
        const int pixel = row % renderer_->down * renderer_->across + column % renderer_->across;
        blend(cell, static_cast<std::size_t>(pixel), brush.ink, brush.tone / 255.0);
    }
}

// An axis-parallel capsule covers whole pixels, as many wherever it lies, so bars of one thickness
// look alike, and two that share an end meet in a clean corner. Returns its radius. (Renderers with
// regions have characters for lines in between.)
double Raster::snap_to_pixels(RasterPoint& start, RasterPoint& end, double radius) const {
    if (start.x != end.x && start.y != end.y) return radius;
    const double across = start.y == end.y ? height_ : width_;
    const double pixels = std::max(1.0, std::round(2.0 * radius / across));
    const double snapped = 0.5 * pixels * across;
    // A middle on a border between pixels, or in a pixel.
    const auto snap = [&](double x, double size) {
        const bool is_even = std::fmod(std::round(2.0 * snapped / size), 2.0) == 0.0;
        return is_even ? std::round(x / size) * size : middle_of_sample(x, size);
    };
    start = {snap(start.x, width_), snap(start.y, height_)};
    end = {snap(end.x, width_), snap(end.y, height_)};
    return snapped;
}

void Raster::capsule(RasterPoint start, RasterPoint end, double radius, const Brush& painted) {
    if (!is_finite(start) || !is_finite(end) || !std::isfinite(radius) || radius < 0.0) return;
    Brush brush = painted;
    brush.ink = visible(painted.ink);
    const bool is_point = start.x == end.x && start.y == end.y;
    const bool is_flat = std::abs(end.x - start.x) * height_ >= std::abs(end.y - start.y) * width_;
    const double half_pixel = is_point ? 0.0 : 0.5 * (is_flat ? height_ : width_);
    const bool is_thin = radius <= std::max(hairline(), half_pixel);
    double thickness = std::max(radius, hairline());
    if (!renderer_->has_regions() && (!is_point || is_thin))
        thickness = snap_to_pixels(start, end, thickness);
    const bool is_sharp = (is_sharp_ && renderer_->is_sharp) || brush.is_crisp;
    if (is_thin && is_sharp && renderer_->has_pixels() && brush.tone > 0)
        return thin_line(start, end, brush);
    if (renderer_->has_regions() && !is_point && radius <= widest_line && brush.tone > 0) {
        return lines_.draw({start.x, start.y / aspect_}, {end.x, end.y / aspect_}, brush.ink,
                           brush.tone < least_strong);
    }
    paint_capsule(start, end, thickness, brush);
}

// A capsule by the coverage of each sample.
void Raster::paint_capsule(RasterPoint start, RasterPoint end, double thickness,
                           const Brush& brush) {
    const double clearance = std::max(width_, height_);
    const double reach = thickness + clearance;
    const double along_x = end.x - start.x;
    const double along_y = end.y - start.y;
    const double squared_length = along_x * along_x + along_y * along_y;
    const double per_length = squared_length > 0.0 ? 1.0 / squared_length : 0.0;
    if (!std::isfinite(squared_length) || !std::isfinite(per_length)) return;

    const auto span_at = [&](double top, double bottom) {
        // The part of the spine that is near enough to this row, as parameters from 0 to 1.
        double first = 0.0;
        double last = 1.0;
        if (std::abs(along_y) > 1e-9) {
            const double a = (top - reach - start.y) / along_y;
            const double b = (bottom + reach - start.y) / along_y;
            first = std::max(first, std::min(a, b));
            last = std::min(last, std::max(a, b));
            if (first > last) return Span{};
        }
        const double a = start.x + first * along_x;
        const double b = start.x + last * along_x;
        return columns_within(std::min(a, b) - reach, std::max(a, b) + reach);
    };
    const auto nearest = [&](double x, double y) {
        const double t = ((x - start.x) * along_x + (y - start.y) * along_y) * per_length;
        const double at = std::clamp(t, 0.0, 1.0);
        return RasterPoint{x - start.x - at * along_x, y - start.y - at * along_y};
    };
    const double half_diagonal = 0.5 * std::sqrt(1.0 + aspect_ * aspect_);
    const double deep = std::max(0.0, thickness - clearance - half_diagonal);
    const auto inside = [&](double x, double y) {
        const RasterPoint offset = nearest(x, y);
        return offset.x * offset.x + offset.y * offset.y < deep * deep;
    };
    const auto coverage = [&](double x, double y) -> Cover {
        const RasterPoint offset = nearest(x, y);
        const double squared = offset.x * offset.x + offset.y * offset.y;
        if (squared > reach * reach) return {};
        const double d = std::sqrt(squared);
        const double width = filter_width(offset.x, offset.y, d);
        const double cover = covered((d + thickness) / width) - covered((d - thickness) / width);
        return {cover, cover};
    };
    paint_rows(std::min(start.y, end.y) - reach, std::max(start.y, end.y) + reach, brush, span_at,
               inside, coverage);
}

void Raster::line(RasterPoint start, RasterPoint end, const Ink& ink, std::uint8_t strength) {
    capsule(start, end, 0.0, {ink, strength, '\0'});
}

}  // namespace carom
