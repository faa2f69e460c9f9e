#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "terminal/draw/draw_parts.h"

/// Draws balls and round edges.
namespace carom {

namespace {

// Without colour, characters or the density of dots distinguish a filled ball from an edge and from
// balls of other kinds. Edges are solid.
struct Texture {
    std::array<std::string_view, 3> stamps;  ///< in ASCII, for a ball of one to three columns
    char fill;                               ///< the inside of a larger ball
    std::uint8_t tone;                       ///< of its dots
};
constexpr std::array<Texture, 6> textures = {{{{"o", "()", "(o)"}, ':', 130},
                                              {{"@", "{}", "(@)"}, 'o', 0},
                                              {{"x", "<>", "(x)"}, '+', 70},
                                              {{"&", "[]", "(+)"}, ' ', 190},
                                              {{"%", "(}", "(%)"}, 'x', 40},
                                              {{"e", "{)", "(=)"}, '.', 160}}};
constexpr std::string_view peg_stamp = "+";

// Where colours tell kinds apart, one texture for all is calmer.
const Texture& texture_of(const View& view, std::size_t ball) {
    const std::size_t kind = view.options.look.has_colors() ? 0 : view.world.balls().kind[ball];
    return textures[kind % textures.size()];
}

// ASCII: the radii, in columns, from which a ball is drawn as one, two or three characters, and
// from which it is larger. Characters do not change while the ball moves; shapes of so few cells
// would flicker. Below the first radius a ball is a dot, whose position shows within the cell.
constexpr std::array<double, 4> stamp_radii = {0.35, 0.75, 1.25, 1.9};

// Larger balls, of several rows. A blank is the inside.
struct LargeStamp {
    double radius;  ///< from which it is used, in columns
    std::array<std::string_view, 4> rows;
};
constexpr std::array<LargeStamp, 4> large_stamps = {
    {{1.9, {"/\"\"\\", "\\__/"}},
     {2.4, {".-.", "(   )", "'-'"}},
     {3.0, {".---.", "(     )", "'---'"}},
     {3.7, {".----.", "/      \\", "\\      /", "'----'"}}}};
// From this radius on, a ball is a ring around a middle that lies on the grid of cells, so that it
// has the same shape wherever it is.
constexpr double least_ring = 4.6;

// The width, in columns, of the stamp for this radius; 0: none.
std::size_t stamp_width(const Raster& raster, double radius) {
    if (!raster.renderer().has_regions() || radius >= stamp_radii.back()) return 0;
    const auto above = std::upper_bound(stamp_radii.begin(), stamp_radii.end(), radius);
    return static_cast<std::size_t>(above - stamp_radii.begin());
}

// Writes the rows below each other, their middle as near to `center` as cells allow.
void stamp_rows(Raster& raster, RasterPoint center, const LargeStamp& stamp, char inside,
                const Ink& ink) {
    const auto rows = std::ranges::count_if(stamp.rows, [](auto row) { return !row.empty(); });
    const double aspect = raster.aspect();
    const double top = std::floor(center.y / aspect - 0.5 * static_cast<double>(rows) + 0.5);
    const std::size_t width = std::ranges::max(stamp.rows, {}, &std::string_view::size).size();
    const double left = std::floor(center.x - 0.5 * static_cast<double>(width) + 0.5);
    for (int row = 0; row < rows; ++row) {
        std::string text(stamp.rows[static_cast<std::size_t>(row)]);
        std::ranges::replace(text, ' ', inside);
        raster.stamp({left + 0.5 * static_cast<double>(width), (top + row + 0.5) * aspect}, text,
                     ink);
    }
}

// The nearest place on the grid of cells, around which a shape is the same everywhere: in the
// middle of a row or between rows, so that its uppermost row is more than a sliver.
RasterPoint on_grid(const Raster& raster, RasterPoint center, double radius) {
    const double aspect = raster.aspect();
    const double rows = radius / aspect;
    const double offset = rows - std::floor(rows) < 0.5 ? 0.5 : 0.0;
    return {std::round(center.x), (std::round(center.y / aspect - offset) + offset) * aspect};
}

bool is_rimmed(const Raster& raster, double radius) {
    return radius >= raster.renderer().least_rimmed;
}

Brush rimmed_brush(const Raster& raster, const View& view, std::size_t ball) {
    const Ink ink = view.inks[ball];
    if (view.options.ball_style == BallStyle::outline) return {ink, 0, ' '};
    // Pixels that are either lit or dark have no pattern fine enough for an inside.
    if (raster.renderer().has_pixels()) return {ink, 0, '\0'};
    const Texture& texture = texture_of(view, ball);
    if (raster.renderer().has_regions()) return {ink, 0, texture.fill};
    return {ink, texture.tone, '\0'};
}

// A radius in the direction of motion, where the speed is large enough to have one.
void paint_heading(Raster& raster, RasterPoint center, double radius, Vec2 velocity,
                   const Ink& ink) {
    const double speed = length(velocity);
    if (!(speed > 0.0) || !std::isfinite(speed)) return;
    const Vec2 way = velocity / speed * radius;
    raster.line(center, {center.x + way.x, center.y - way.y}, ink);
}

// Balls look like spheres where pixels show it and there are few enough to look at each.
constexpr std::size_t most_lit_balls = 250;
// The least diameter, in pixels. On smaller balls that move, a highlight costs as many bytes as the
// rest of the ball. The few balls of pool and pinball have one from three pixels on.
constexpr double least_lit = 5.0;
// Of balls of this diameter, in pixels, a window never holds many, however many small ones there
// are.
constexpr double always_lit = 10.0;

bool is_lit(const View& view, std::size_t ball) {
    if (!view.options.look.has_shades()) return false;
    const double diameter = 2.0 * view.world.balls().radius[ball] * view.camera.columns_per_length *
                            renderer_in_force(view.options).across;
    if (view.world.balls().size() > most_lit_balls) return diameter >= always_lit;
    return view.annotations.pool || view.annotations.table || diameter >= least_lit;
}

BallPaint ball_paint(const View& view, std::size_t ball) {
    const Look& look = view.options.look;
    BallPaint paint;
    paint.tones = tones_of(view.inks[ball].color, look);
    paint.number_width = number_width(view, ball);
    paint.attributes = view.inks[ball].attributes;
    paint.is_lit = is_lit(view, ball);
    if (is_striped(view, ball)) {
        paint.band = paint.tones;
        paint.tones = tones_of(ink_of(Role::stripe_white, look).color, look);
    }
    return paint;
}

/// The middles of balls whose pixels may overlap those of one ball: at most six as large touch it.
struct Rivals {
    std::array<RasterPoint, 6> middles{};
    std::size_t count = 0;
};

// At pool alone, where racks are looked at ball by ball.
Rivals rivals_of(const View& view, std::size_t ball) {
    Rivals rivals;
    if (!view.annotations.pool) return rivals;
    const Balls& balls = view.world.balls();
    constexpr double near = 1.5;  // sums of radii
    for (std::size_t i = 0; i < balls.size() && rivals.count < rivals.middles.size(); ++i) {
        const double reach = near * (balls.radius[i] + balls.radius[ball]);
        if (i == ball || length(balls.position[i] - balls.position[ball]) > reach) continue;
        rivals.middles[rivals.count++] = to_raster(view.camera, balls.position[i]);
    }
    return rivals;
}

// At pool the cue ball must be larger than the dots of the aim line, so a ball that is about as
// large as a pixel takes two.
double radius_at_pool(const Raster& raster, const View& view, double radius) {
    constexpr double most_enlarged = 1.5;
    const double least = 0.75 / raster.renderer().across;
    if (!view.annotations.pool || radius >= least) return radius;
    return most_enlarged * radius >= least ? least : radius;
}

void paint_ball(Raster& raster, const View& view, std::size_t ball, RasterPoint center) {
    const double radius = view.world.balls().radius[ball] * view.camera.columns_per_length;
    if (const std::size_t width = stamp_width(raster, radius)) {
        raster.stamp(center, texture_of(view, ball).stamps[width - 1], view.inks[ball]);
        return;
    }
    if (raster.renderer().has_regions()) {
        if (radius < least_ring && radius >= stamp_radii.back()) {
            const auto above =
                std::ranges::upper_bound(large_stamps, radius, {}, &LargeStamp::radius);
            const bool is_outline = view.options.ball_style == BallStyle::outline;
            const bool is_plain = is_outline || view.options.look.has_colors();
            stamp_rows(raster, center, *(above - 1), is_plain ? ' ' : texture_of(view, ball).fill,
                       view.inks[ball]);
            return;
        }
        if (radius >= least_ring) center = on_grid(raster, center, radius - raster.renderer().gap);
    }
    const double gap = raster.renderer().gap;
    const double shown = radius > 4.0 * gap ? radius - gap : radius;
    const bool is_flat = raster.renderer().has_pixels() && view.options.look.has_colors();
    if (is_flat && view.options.ball_style == BallStyle::filled) {
        const Rivals rivals = rivals_of(view, ball);
        BallPaint paint = ball_paint(view, ball);
        paint.rivals = std::span(rivals.middles).first(rivals.count);
        const bool is_full = paint.is_lit || view.annotations.pool.has_value();
        raster.ball(center, is_full ? radius_at_pool(raster, view, radius) : shown, paint);
        return;
    }
    if (!is_rimmed(raster, radius)) {
        raster.disc(center, shown, 0.0, {view.inks[ball], 255, '@'});
        return;
    }
    const Brush brush = rimmed_brush(raster, view, ball);
    raster.disc(center, shown, 2.0 * raster.hairline(), brush);
    if (view.options.ball_style == BallStyle::outline) {
        paint_heading(raster, center, shown, view.world.balls().velocity[ball], brush.ink);
    }
}

Level level_of_ball(const View& view, std::size_t ball) {
    const auto& kinds = view.world.kinds();
    const std::size_t kind = view.world.balls().kind[ball];
    return kind < kinds.size() && kinds[kind].layer > 0 ? Level::above : Level::board;
}

}  // namespace

int middle_row(const View& view, double radius, double row) {
    const double columns = radius * view.camera.columns_per_length;
    if (!renderer_in_force(view.options).has_regions() || columns < large_stamps.front().radius)
        return static_cast<int>(std::floor(row));
    if (columns >= least_ring) return static_cast<int>(std::floor(row));
    const auto above = std::ranges::upper_bound(large_stamps, columns, {}, &LargeStamp::radius);
    const bool is_even =
        (above - 1)->rows[1].size() == (above - 1)->rows[0].size() || !(above - 1)->rows[3].empty();
    return static_cast<int>(is_even ? std::round(row) : std::floor(row));
}

void paint_peg(Raster& raster, RasterPoint center, double radius, const Brush& brush) {
    const bool is_stamp = raster.renderer().has_regions() && radius < least_ring;
    if (is_stamp && radius < stamp_radii[1]) return raster.stamp(center, peg_stamp, brush.ink);
    if (is_stamp && radius >= large_stamps.front().radius) {
        const auto above = std::ranges::upper_bound(large_stamps, radius, {}, &LargeStamp::radius);
        return stamp_rows(raster, center, *(above - 1), brush.fill, brush.ink);
    }
    const double shown = std::max(radius, raster.hairline());
    if (!raster.renderer().has_pixels()) return raster.disc(center, shown, 0.0, brush);
    const Color color = brush.ink.color;
    const BallPaint flat{.tones = {color, color, color, color}, .attributes = brush.ink.attributes};
    raster.ball(center, shown, flat);
}

void paint_balls(Raster& raster, const View& view, Level level) {
    const Balls& balls = view.world.balls();
    const Box visible = visible_box(view.camera);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        if (level_of_ball(view, i) != level) continue;
        const Box box = bounds(Disc{balls.position[i], balls.radius[i]});
        for (const Vec2 offset : images_of(view.world.model(), box, view.camera)) {
            if (!overlaps({box.low + offset, box.high + offset}, visible)) continue;
            paint_ball(raster, view, i, to_raster(view.camera, balls.position[i] + offset));
        }
    }
}

}  // namespace carom
