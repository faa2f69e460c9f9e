#include <algorithm>
#include <cmath>

#include "terminal/canvas/raster.h"

/// Paints balls with pixels: shaded spheres of the same shape wherever they lie.
namespace carom {

namespace {

// Balls of up to this many pixels across lie on whole pixels even where borders are smoothed.
constexpr double most_snapped = 6.0;
// A diameter this much short of a whole number of pixels still counts as that number.
constexpr double rounding = 0.2;
// A ball of fewer pixels is a square of one pixel or of two, whichever is nearer in ratio. A border
// of half-covered pixels around so small a square would make a cross of it.
constexpr double least_two = 1.4142135623730951;   // sqrt(1 * 2)
constexpr double least_three = 2.449489742783178;  // sqrt(2 * 3)
// Balls of fewer pixels are as wide as the pixels on which they lie: a rim beyond them would be
// faint.
constexpr double most_whole = 5.0;
// Where borders are sharp: the share of a pixel that a ball must cover to have it. A little less
// than half, since four pixels by three, without the corners, would be a cross.
constexpr double least_ball_cover = 0.45;
// From this many pixels across, a sphere has room for a shadow and a highlight.
constexpr int least_shaded = 3;

/// The pixels of a ball along one axis.
struct Extent {
    double first = 0.0;  // the border of the first pixel, in pixels
    double size = 1.0;   // the diameter, in pixels
    int begin = 0;       // pixels that it may cover: begin <= i < end
    int end = 0;
};

// The side of the square of pixels on which a ball of this diameter lies.
double whole_pixels(double diameter) {
    if (diameter < least_three) return diameter < least_two ? 1.0 : 2.0;
    return std::max(3.0, std::floor(diameter + rounding));
}

// Snapped to whole pixels: the middle of the ball is the middle of a pixel or a border, so that the
// same pixels are covered wherever it is. `is_sharp`: the diameter is whole too.
// `is_under_number`: the middle stays where it is.
Extent extent_of(double center, double diameter, bool is_snapped, bool is_sharp,
                 bool is_under_number, int count) {
    Extent extent;
    extent.size = diameter;
    extent.first = center - 0.5 * diameter;
    if (is_snapped) {
        double whole = whole_pixels(diameter);
        if (is_under_number) {
            const bool is_odd = center != std::floor(center);
            if (is_odd != (static_cast<int>(std::min(whole, 1e6)) % 2 == 1))
                whole += diameter >= whole || whole < 2.0 ? 1.0 : -1.0;
        }
        const double first = std::round(center - 0.5 * whole);
        if (is_sharp || diameter < (is_under_number ? least_three : most_whole))
            extent.size = whole;
        extent.first = first + 0.5 * (whole - extent.size);
    }
    const double most = count;
    extent.begin = static_cast<int>(std::clamp(std::floor(extent.first), 0.0, most));
    extent.end = static_cast<int>(std::clamp(std::ceil(extent.first + extent.size), 0.0, most));
    return extent;
}

/// From -1 to 1 across the ball: the middle of a pixel.
double place_in(const Extent& extent, int pixel) {
    return 2.0 * (pixel + 0.5 - extent.first) / extent.size - 1.0;
}

// Light from the upper left; `x` and `y` from -1 to 1, y downwards.
Color lit_tone(const Tones& tones, double x, double y, int pixels) {
    const double squared = x * x + y * y;
    const double z = squared < 1.0 ? std::sqrt(1.0 - squared) : 0.0;
    const double light = -0.45 * x - 0.55 * y + 0.70 * z;
    constexpr int least_glinting = 6;
    if (pixels >= least_glinting && light > 0.975) return tones.glint;
    if (light > 0.895) return tones.light;
    if (light < (pixels < least_glinting ? 0.0 : 0.22)) return tones.shadow;
    return tones.base;
}

double distance_squared(RasterPoint a, RasterPoint b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

// Whether a rival of the same size, in columns, covers the place too and is nearer to it.
bool belongs_to_rival(std::span<const RasterPoint> rivals, RasterPoint place, RasterPoint center,
                      RasterPoint size) {
    const double own = distance_squared(place, center);
    return std::ranges::any_of(rivals, [&](RasterPoint rival) {
        const bool is_covered = std::abs(place.x - rival.x) < 0.5 * size.x &&
                                std::abs(place.y - rival.y) < 0.5 * size.y;
        return is_covered && distance_squared(place, rival) < own;
    });
}

/// A pixel that a ball covers.
struct PixelOfBall {
    double x = 0.0;  ///< from -1 to 1 across the ball; y downwards
    double y = 0.0;
    int column = 0;
    int row = 0;
    int pixels = 0;       ///< across the ball
    bool is_low = false;  ///< the ball has fewer than three rows
    double cover = 0.0;   ///< the covered share of the pixel
};

}  // namespace

// The middle of the cells that a number of this width covers when it is written on the ball.
RasterPoint Raster::middle_of_number(RasterPoint center, int width) const {
    const double half = 0.5 * width;
    return {std::floor(center.x - half + 0.5) + half,
            (std::floor(center.y / aspect_) + 0.5) * aspect_};
}

// Calls paint(const PixelOfBall&) for each of them.
template <class Paint>
void Raster::paint_ball(RasterPoint center, double radius, const BallPaint& ball, Paint paint) {
    if (!std::isfinite(center.x) || !std::isfinite(center.y) || !std::isfinite(radius)) return;
    if (!renderer_->has_pixels() || !(radius >= 0.0)) return;
    const double across = 2.0 * radius / width_;
    const double down = 2.0 * radius / height_;
    const bool has_number = ball.number_width > 0;
    const bool is_sharp = is_sharp_ || ball.is_crisp;
    if (has_number) center = middle_of_number(center, ball.number_width);
    const bool is_snapped = has_number || is_sharp || std::min(across, down) <= most_snapped;
    const Extent columns =
        extent_of(center.x / width_, across, is_snapped, is_sharp, has_number, samples_across());
    const Extent rows =
        extent_of(center.y / height_, down, is_snapped, is_sharp, has_number, samples_down());
    const bool is_square = is_snapped && std::max(columns.size, rows.size) <= 2.0;
    const RasterPoint size{columns.size * width_, rows.size * height_};
    PixelOfBall at;
    at.pixels = static_cast<int>(std::min({columns.size, rows.size, 1000.0}));
    at.is_low = rows.size < 3.0;
    for (at.row = rows.begin; at.row < rows.end; ++at.row) {
        at.y = place_in(rows, at.row);
        for (at.column = columns.begin; at.column < columns.end; ++at.column) {
            at.x = place_in(columns, at.column);
            const double distance = std::sqrt(at.x * at.x + at.y * at.y);
            // The border, in pixels along its normal, and the width over which it crosses one.
            const double width =
                distance < 1e-9 ? 1.0 : (std::abs(at.x) + std::abs(at.y)) / distance;
            const double depth = 0.5 * (1.0 - distance) * std::min(columns.size, rows.size);
            at.cover = std::clamp(depth / width + 0.5, 0.0, 1.0);
            if (is_sharp || is_square) at.cover = at.cover >= least_ball_cover ? 1.0 : 0.0;
            const RasterPoint middle{(at.column + 0.5) * width_, (at.row + 0.5) * height_};
            if (at.cover > 0.0 && !belongs_to_rival(ball.rivals, middle, center, size)) paint(at);
        }
    }
}

void Raster::blend_pixel(int column, int row, const Ink& ink, double opacity) {
    if (column >= samples_across() || row >= samples_down()) return;
    CellSamples& cell = cell_at(column / renderer_->across, row / renderer_->down);
    const int i = row % renderer_->down * renderer_->across + column % renderer_->across;
    blend(cell, static_cast<std::size_t>(i), visible(ink), opacity);
}

void Raster::ball(RasterPoint center, double radius, const BallPaint& paint) {
    paint_ball(center, radius, paint, [&](const PixelOfBall& at) {
        // A stripe is half as high as the ball; where there are two rows, it is the lower one.
        const bool is_band = paint.band && (at.is_low ? at.y > 0.0 : std::abs(at.y) < 0.5);
        const Tones& tones = is_band ? *paint.band : paint.tones;
        const bool is_shaded = paint.is_lit && at.pixels >= least_shaded;
        const Color color = is_shaded ? lit_tone(tones, at.x, at.y, at.pixels) : tones.base;
        blend_pixel(at.column, at.row, {color, paint.attributes}, at.cover);
    });
}

void Raster::ball_shadow(RasterPoint center, double radius, const BallPaint& paint, Color color) {
    constexpr double darkness = 0.42;
    paint_ball(center, radius, paint, [&](const PixelOfBall& at) {
        if (at.pixels < least_shaded) return;
        // By whole pixels, so that the shadow has one shape wherever the ball is.
        const int away = std::max(1, at.pixels / 7);
        blend_pixel(at.column + away, at.row + away, {color, plain}, darkness * at.cover);
    });
}

}  // namespace carom
