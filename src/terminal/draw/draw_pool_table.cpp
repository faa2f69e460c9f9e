#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "terminal/draw/board.h"
#include "terminal/draw/draw_parts.h"
#include "terminal/draw/ground.h"

/// Draws what lies on and in a pool table under its balls: pockets, diamonds, lines and spots.
namespace carom {

namespace {

constexpr Rgb24 leather_color = 0x2b190d;
constexpr Rgb24 diamond_color = 0xe9dfc4;
constexpr Rgb24 chalk_color = 0x7fb697;  // on green cloth: a mixture of both
constexpr Rgb chalk_rgb{0x7f, 0xb6, 0x97};
constexpr double leather_share = 0.94;  // of the pocket's radius

// Leather shows around a hole of this many columns or more. Around a smaller one it would only blur
// the border.
constexpr double least_leather = 2.0;

double hole_radius(const View& view, const Capsule& pocket) {
    // Two pixels at least: a smaller hole would be lost among the cushions.
    const double least = 1.0 / renderer_in_force(view.options).across;
    return std::max(least, hole_share * pocket.radius * view.camera.columns_per_length);
}

void paint_leather(Raster& raster, const View& view) {
    const Ink leather = dress_ink(leather_color, view.options.look);
    for (const std::uint32_t pocket : view.scene.pool.pockets) {
        const Capsule& shape = view.world.zones()[pocket].shape;
        if (hole_radius(view, shape) < least_leather) continue;
        const double radius = leather_share * shape.radius * view.camera.columns_per_length;
        raster.disc(to_raster(view.camera, shape.start), radius, 0.0, {leather, 255, '\0'});
    }
}

// The axes of a table with a rack: from its middle towards the foot, and across.
struct TableAxes {
    Vec2 middle;
    Vec2 along;
    Vec2 across;
    double length = 0.0;  ///< from the middle to the foot cushion's nose
    double width = 0.0;
};

// The distance from `from` along `way` to where the bed ends.
double reach(const Board& board, Vec2 from, Vec2 way, double most) {
    constexpr int steps = 400;
    for (int i = 1; i <= steps; ++i)
        if (board.at(from + way * (most * i / steps)) != Ground::board) return most * i / steps;
    return most;
}

// Only of a table with six pockets, four or none, symmetric about its middle: others have no
// diamonds.
std::optional<TableAxes> axes_of(const View& view, const Board& board) {
    const std::vector<std::uint32_t>& pockets = view.scene.pool.pockets;
    if (!pockets.empty() && pockets.size() != 4 && pockets.size() != 6) return std::nullopt;
    std::optional<Box> box;
    if (pockets.empty()) box = board.frame();
    for (const std::uint32_t pocket : pockets) {
        const Vec2 at = view.world.zones()[pocket].shape.start;
        box = box ? join(*box, {at, at}) : Box{at, at};
    }
    TableAxes axes;
    axes.middle = center(*box);
    const bool is_wide = size(*box).x >= size(*box).y;
    axes.along = is_wide ? Vec2{1.0, 0.0} : Vec2{0.0, 1.0};
    axes.across = is_wide ? Vec2{0.0, 1.0} : Vec2{1.0, 0.0};
    if (!view.scene.pool.racks.empty() &&
        dot(view.scene.pool.racks.front().foot - axes.middle, axes.along) < 0.0)
        axes.along = axes.along * -1.0;
    // Beside the middle, where a side pocket may be.
    const double most = length(size(*box));
    const Vec2 beside = axes.middle + axes.along * (0.2 * most);
    axes.length = reach(board, axes.middle, axes.along, most);
    axes.width = reach(board, beside, axes.across, most);
    // A table without pockets has diamonds if it is as long as two squares, as those of caroms are.
    constexpr double tolerance = 0.1;
    const bool is_double = std::abs(axes.length - 2.0 * axes.width) < tolerance * axes.length;
    if (pockets.empty() && !is_double) return std::nullopt;
    return axes;
}

// Without shades nothing can be faint, so a line of chalk is every second pixel, in the colour of
// the cloth, if there are colours.
void paint_pixel_line(Raster& raster, const View& view, RasterPoint start, RasterPoint end) {
    const Look& look = view.options.look;
    const Ink ink{look.has_colors() ? color_of_hue(chalk_rgb, look) : default_color, plain};
    const double width = 1.0 / raster.renderer().across;
    const double height = raster.aspect() / raster.renderer().down;
    const Vec2 apart{end.x - start.x, end.y - start.y};
    constexpr double most = 2000.0;  // a longer line leaves the window
    if (!(length(apart) <= most)) return;
    const int steps = static_cast<int>(length(apart) / std::min(width, height)) + 1;
    for (int i = 0; i <= steps; ++i) {
        const int across = static_cast<int>(std::floor((start.x + apart.x * i / steps) / width));
        const int down = static_cast<int>(std::floor((start.y + apart.y * i / steps) / height));
        const bool is_within = across >= 0 && across < raster.samples_across() && down >= 0 &&
                               down < raster.samples_down();
        if (is_within && (across + down) % 2 == 0) raster.sample(across, down, 255, ink);
    }
}

// A line on the cloth, faint as chalk.
void paint_chalk_line(Raster& raster, const View& view, Vec2 from, Vec2 to) {
    const RasterPoint start = to_raster(view.camera, from);
    const RasterPoint end = to_raster(view.camera, to);
    if (paints_tables(raster, view))
        return raster.line(start, end, {view.memory.ground.inks().chalk, plain});
    if (raster.renderer().has_pixels()) return paint_pixel_line(raster, view, start, end);
    // Faint, but of dots in every row, whichever column of dots the line is in.
    const std::uint8_t strength = raster.renderer().has_dots() ? 120 : 60;
    raster.line(start, end, dress_ink(chalk_color, view.options.look), strength);
}

// A head string, a foot spot and a head spot.
void paint_markings(Raster& raster, const View& view, const TableAxes& axes) {
    const Ink chalk = dress_ink(chalk_color, view.options.look);
    const Vec2 head = axes.middle - axes.along * (0.5 * axes.length);
    const Vec2 foot = axes.middle + axes.along * (0.5 * axes.length);
    paint_chalk_line(raster, view, head - axes.across * axes.width,
                     head + axes.across * axes.width);
    for (const Vec2 spot : {head, foot})
        raster.disc(to_raster(view.camera, spot), 0.0, 0.0, {chalk, 255, '\0'});
}

// The baulk line, its D, and the spots of the colours of snooker.
void paint_baulk(Raster& raster, const View& view, const TableAxes& axes, const BaulkD& d) {
    constexpr int steps = 24;
    const Ink chalk = dress_ink(chalk_color, view.options.look);
    const auto line = [&](Vec2 from, Vec2 to) { paint_chalk_line(raster, view, from, to); };
    line(d.middle - axes.across * axes.width, d.middle + axes.across * axes.width);
    Vec2 from = d.middle + axes.across * d.radius;
    for (int i = 1; i <= steps; ++i) {
        const SinCos turn = sin_cos_degrees(180.0 * i / steps);
        const Vec2 to = d.middle + (axes.across * turn.cos - axes.along * turn.sin) * d.radius;
        line(from, to);
        from = to;
    }
    const World& start = view.scene.world;
    for (const BallId ball : view.scene.pool.others) {
        const Vec2 spot = start.balls().position[*index_of(start, ball)];
        raster.disc(to_raster(view.camera, spot), 0.0, 0.0, {chalk, 255, '\0'});
    }
}

void paint_diamonds(Raster& raster, const View& view, const Board& board, const TableAxes& axes) {
    const Ink ivory = dress_ink(diamond_color, view.options.look);
    const double rail = 0.5 * (size(board.frame()).x - 2.0 * std::abs(axes.along.x * axes.length +
                                                                      axes.across.x * axes.width));
    const double out = 0.68 * rail;
    const double radius = 0.06 * rail * view.camera.columns_per_length;
    const auto diamond = [&](double along, double across) {
        const Vec2 at = axes.middle + axes.along * along + axes.across * across;
        fill_dot(raster, to_raster(view.camera, at), radius, ivory);
    };
    for (const int side : {-1, 1}) {
        // A side pocket is in the middle.
        for (int i = -3; i <= 3; ++i)
            if (i != 0 || view.scene.pool.pockets.empty())
                diamond(0.25 * i * axes.length, side * (axes.width + out));
        for (int i = -1; i <= 1; ++i)
            diamond(side * (axes.length + out), 0.5 * i * axes.width);
    }
}

}  // namespace

bool paints_tables(const Raster& raster, const View& view) {
    return raster.renderer().has_pixels() && view.options.look.has_shades();
}

bool paint_pocket(Raster& raster, const View& view, std::size_t zone) {
    if (!raster.renderer().has_pixels() || std::ranges::count(view.scene.pool.pockets, zone) == 0)
        return false;
    if (paints_tables(raster, view)) return true;
    // Without shades, a hole has no colour of its own, but a rim as cushions have.
    const Capsule& shape = view.world.zones()[zone].shape;
    const double radius = shape.radius * view.camera.columns_per_length;
    raster.disc(to_raster(view.camera, shape.start), radius, 2.0 * raster.hairline(),
                {ink_of(Role::edge, view.options.look), 0, '\0'});
    return true;
}

void paint_holes(Raster& raster, const View& view) {
    if (!raster.renderer().has_pixels()) return;
    const Look& look = view.options.look;
    const Color color = dress_ink(hole_color, look).color;
    // A rim of so few pixels would hide the hole, which shows on cloth without one.
    const double least_rimmed = 3.0 / raster.renderer().across;
    for (const std::uint32_t pocket : view.scene.pool.pockets) {
        const Capsule& shape = view.world.zones()[pocket].shape;
        const RasterPoint at = to_raster(view.camera, shape.start);
        const double radius = hole_radius(view, shape);
        if (look.has_shades())
            raster.ball(at, radius, {.tones = {color, color, color, color}, .is_crisp = true});
        else if (look.has_colors() && radius < least_rimmed)
            raster.disc(at, radius / hole_share, 0.0, {{}, 0, '\0', false, true});
    }
}

void paint_pool_table(Raster& raster, const View& view, const Board& board) {
    if (!is_pool_table(view.scene)) return;
    const bool is_painted = paints_tables(raster, view);
    if (board.is_empty()) return is_painted ? paint_leather(raster, view) : void();
    const std::optional<TableAxes> axes = axes_of(view, board);
    const std::optional<BaulkD>& d = view.scene.pool.d;
    // The rules speak of these lines, so renderers without pixels draw them too.
    if (axes && d)
        paint_baulk(raster, view, *axes, *d);
    else if (axes && !view.scene.pool.racks.empty())
        paint_markings(raster, view, *axes);
    if (!is_painted) return;
    if (axes && !d) paint_diamonds(raster, view, board, *axes);
    paint_leather(raster, view);
}

}  // namespace carom
