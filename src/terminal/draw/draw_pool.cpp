#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "terminal/draw/draw_parts.h"

/// Draws a pool table: its cloth, the colours and numbers of balls, and the aiming lines.
namespace carom {

namespace {

bool is_stripe(int number) {
    return number > 8;
}

int number_of(const PoolAnnotations& pool, BallId ball) {
    const auto found = std::ranges::find(pool.numbers, ball, &PoolAnnotations::Number::ball);
    return found == pool.numbers.end() ? -1 : found->number;
}

void paint_dot(Raster& raster, RasterPoint at, const Ink& ink) {
    if (raster.renderer().has_regions())
        raster.stamp(at, ".", ink);
    else
        raster.disc(at, 0.0, 0.0, {ink, 255, '\0'});
}

// The columns of the widest number, with a pixel or so of the ball around it.
constexpr double least_round = 2.75;

// Among pixels, the ball looks round around its number. A smaller one is no more than the cells of
// its number.
bool is_round(const Renderer& renderer, double diameter) {
    return renderer.has_pixels() && diameter >= least_round;
}

// The number of a small ball is as wide as the ball: in ASCII, and where the ball is no more than
// the cells of its number.
std::string label_of(const View& view, int number, double radius) {
    std::string text = std::to_string(number);
    const double columns = 2.0 * radius * view.camera.columns_per_length;
    constexpr double least_two = 1.5;
    constexpr double least_two_pixels = 1.0;
    constexpr double least_three = 2.5;
    constexpr double least_large = 3.8;  // it has a rim
    const Renderer& renderer = renderer_in_force(view.options);
    if (renderer.has_pixels()) {
        const bool is_padded = columns >= least_two_pixels && !is_round(renderer, columns);
        return is_padded && text.size() == 1 ? " " + text : text;
    }
    if (!renderer.has_regions() || columns >= least_large) return text;
    if (text.size() == 1 && columns >= least_two) text = " " + text;
    if (columns >= least_three) text += " ";
    return text;
}

// Dots along a curved line, evenly spaced, in columns.
void paint_dotted(Raster& raster, const View& view, const std::vector<Vec2>& way, double spacing,
                  const Ink& ink) {
    constexpr double most = 2000.0;  // longer pieces leave the window
    double left = spacing;
    for (std::size_t i = 1; i < way.size(); ++i) {
        const RasterPoint from = to_raster(view.camera, way[i - 1]);
        const RasterPoint to = to_raster(view.camera, way[i]);
        const double dx = to.x - from.x;
        const double dy = to.y - from.y;
        const double size = std::sqrt(dx * dx + dy * dy);
        if (!(size <= most)) return;
        for (; left <= size; left += spacing)
            paint_dot(raster, {from.x + dx * left / size, from.y + dy * left / size}, ink);
        left -= size;
    }
}

void paint_line(Raster& raster, const View& view, const std::optional<PoolAnnotations::Line>& line,
                const Ink& ink, double spacing) {
    if (line) paint_dotted(raster, view, {line->from, line->to}, spacing, ink);
}

Ink ink_of_ball(const View& view, BallId ball) {
    const auto index = index_of(view.world, ball);
    return index ? view.inks[*index] : ink_of(Role::cue, view.options.look);
}

// A ring where a ball comes to rest, or a cross where it is pocketed.
void paint_end(Raster& raster, const View& view, Vec2 place, bool is_pocketed, double radius,
               const Ink& ink) {
    const RasterPoint at = to_raster(view.camera, place);
    if (raster.renderer().has_regions()) {
        raster.stamp(at, is_pocketed ? "*" : "o", ink);
        return;
    }
    const double size = radius * view.camera.columns_per_length;
    if (is_pocketed) {
        raster.line({at.x - 0.7 * size, at.y - 0.7 * size}, {at.x + 0.7 * size, at.y + 0.7 * size},
                    ink);
        raster.line({at.x - 0.7 * size, at.y + 0.7 * size}, {at.x + 0.7 * size, at.y - 0.7 * size},
                    ink);
        return;
    }
    raster.disc(at, size, 2.0 * raster.hairline(), {ink, 0, '\0'});
}

constexpr Rgb24 shaft_color = 0xd9b382;
constexpr Rgb24 butt_color = 0x2a120a;
constexpr Rgb24 ferrule_color = 0xf3efe2;

// A cue that grows thicker from its tip to its butt: the shaft of maple, the butt dark.
void paint_cue(Raster& raster, const View& view, const PoolAnnotations::Line& stick,
               double ball_radius) {
    const Look& look = view.options.look;
    if (!look.has_shades() || raster.renderer().has_regions())
        // Crisp, since without shades a soft line between two rows of pixels is in neither.
        return raster.capsule(to_raster(view.camera, stick.from), to_raster(view.camera, stick.to),
                              0.0, {.ink = ink_of(Role::selected, look), .is_crisp = true});
    struct Piece {
        double from;
        double to;
        double radius;  // in radii of the ball
        Rgb24 color;
    };
    constexpr std::array<Piece, 5> pieces{{{0.0, 0.02, 0.22, ferrule_color},
                                           {0.02, 0.30, 0.24, shaft_color},
                                           {0.30, 0.62, 0.32, shaft_color},
                                           {0.62, 0.80, 0.42, butt_color},
                                           {0.80, 1.0, 0.50, butt_color}}};
    const auto at = [&](double share) {
        return to_raster(view.camera, stick.from + (stick.to - stick.from) * share);
    };
    // From the butt on, so that each piece ends over the one behind it.
    for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece) {
        const double radius = piece->radius * ball_radius * view.camera.columns_per_length;
        // Where borders are sharp, a capsule thinner than a pixel could fall between pixels.
        constexpr double least = 0.55;  // columns
        raster.capsule(at(piece->from), at(piece->to), radius < least ? 0.0 : radius,
                       {.ink = dress_ink(piece->color, look), .is_crisp = true});
    }
}

// Cells that a number covers: first <= column < last.
struct NumberPlace {
    int row = 0;
    int first = 0;
    int last = 0;
};

// Whether no earlier number is there. Takes the place if so.
bool is_free(std::vector<NumberPlace>& taken, const NumberPlace& place) {
    for (const NumberPlace& other : taken)
        if (other.row == place.row && place.first < other.last && other.first < place.last)
            return false;
    taken.push_back(place);
    return true;
}

}  // namespace

void color_pool_balls(std::vector<Ink>& inks, const Scene& scene, const World& world,
                      const PoolAnnotations& pool, const Look& look) {
    if (!look.has_colors()) return;
    const std::vector<ClassIndex>& kinds = world.balls().kind;
    const bool is_by_id = std::ranges::adjacent_find(kinds, std::not_equal_to{}) == kinds.end();
    for (const PoolAnnotations::Returned& back : pool.returned) {
        const auto i = index_of(world, back.ball);
        if (!i) continue;
        auto color = color_in(scene.dress.balls, number(back.before));
        if (!color) color = color_in(scene.dress.kinds, kinds[*i]);
        if (color)
            inks[*i] = dress_ink(*color, look);
        else if (is_by_id)
            inks[*i] = ink_of_class(number(back.before), look);
    }
    for (std::size_t i = 0; i < inks.size(); ++i) {
        const int number = number_of(pool, world.balls().id[i]);
        if (number >= 0) inks[i] = ink_of_pool_ball(number, look);
    }
}

void paint_pool(Raster& raster, const View& view) {
    if (!view.annotations.pool) return;
    const PoolAnnotations& pool = *view.annotations.pool;
    const Look& look = view.options.look;
    const Ink strong = ink_of(Role::cue, look);
    // On cloth, which is dark in every theme. Without shades the background shows through it.
    const bool is_on_cloth = look.light_background && look.has_shades();
    const Ink text = ink_of(is_on_cloth ? Role::stripe_white : Role::text, look);
    const double radius = view.world.balls().size() > 0 ? view.world.balls().radius.front() : 0.0;
    for (const PoolAnnotations::Spot& spot : pool.spots) {
        const RasterPoint at = to_raster(view.camera, spot.place);
        if (raster.renderer().has_regions())
            raster.stamp(at, spot.is_pocketed ? "*" : ":", ink_of_ball(view, spot.ball));
        else
            raster.disc(at, 0.0, 0.0, {ink_of_ball(view, spot.ball), 255, '\0'});
    }
    for (const PoolAnnotations::Track& track : pool.tracks) {
        const Ink ink = ink_of_ball(view, track.ball);
        paint_dotted(raster, view, track.way, 2.0, ink);
        paint_end(raster, view, track.way.back(), track.is_pocketed, radius, ink);
    }
    paint_line(raster, view, pool.aim, text, 2.0);
    paint_line(raster, view, pool.object, strong, 1.5);
    paint_line(raster, view, pool.tangent, text, 2.0);
    if (pool.ghost) {
        const RasterPoint at = to_raster(view.camera, pool.ghost->center);
        const double size = pool.ghost->radius * view.camera.columns_per_length;
        if (raster.renderer().has_regions())
            raster.stamp(at, "()", text);
        else
            raster.disc(at, size, 2.0 * raster.hairline(), {text, 0, '\0'});
    }
    if (pool.stick) paint_cue(raster, view, *pool.stick, radius);
    if (pool.called) {
        const RasterPoint at = to_raster(view.camera, *pool.called);
        raster.disc(at, 1.2, 0.0, {strong, 255, '*'});
    }
}

// Whether the cells of a number on this ball would cover another ball, as they do in a rack of
// small balls: there, colours say more.
bool covers_another(const View& view, std::size_t ball, int width) {
    const Balls& balls = view.world.balls();
    const double scale = view.camera.columns_per_length;
    constexpr double seen = 0.85;  // radii of the other ball: what must stay uncovered
    for (std::size_t i = 0; i < balls.size(); ++i) {
        if (i == ball) continue;
        const Vec2 apart = (balls.position[i] - balls.position[ball]) * scale;
        const Vec2 beyond{std::max(0.0, std::abs(apart.x) - 0.5 * width),
                          std::max(0.0, std::abs(apart.y) - 0.5 * view.camera.aspect)};
        if (length(beyond) < seen * balls.radius[i] * scale) return true;
    }
    return false;
}

bool is_striped(const View& view, std::size_t ball) {
    return view.annotations.pool && view.options.color_by == ColorBy::kind &&
           is_stripe(number_of(*view.annotations.pool, view.world.balls().id[ball]));
}

int number_width(const View& view, std::size_t ball) {
    if (!view.annotations.pool || view.options.labels != Labels::automatic) return 0;
    const int number = number_of(*view.annotations.pool, view.world.balls().id[ball]);
    const double radius = view.world.balls().radius[ball];
    const double diameter = 2.0 * radius * view.camera.columns_per_length;
    constexpr double least = 0.8;  // columns
    if (number <= 0 || diameter < least) return 0;
    const int width = static_cast<int>(label_of(view, number, radius).size());
    // As wide as the widest, so that a rack has all of its numbers or none.
    constexpr int widest = 2;
    return covers_another(view, ball, std::max(width, widest)) ? 0 : width;
}

void write_numbers(Canvas& canvas, const View& view) {
    if (!view.annotations.pool) return;
    const Look& look = view.options.look;
    const CellArea& area = view.camera.area;
    std::vector<NumberPlace> taken;
    for (const PoolAnnotations::Number& ball : view.annotations.pool->numbers) {
        const auto index = index_of(view.world, ball.ball);
        if (!index || ball.number == 0) continue;
        if (number_width(view, *index) == 0) continue;
        const std::string text = label_of(view, ball.number, view.world.balls().radius[*index]);
        const CellPoint at = to_cells(view.camera, view.world.balls().position[*index]);
        const int width = static_cast<int>(text.size());
        const int row = middle_row(view, view.world.balls().radius[*index], at.row);
        const int first = static_cast<int>(std::floor(at.column - 0.5 * width + 0.5));
        if (row < area.row || row >= area.row + area.rows || first < area.column ||
            first + width > area.column + area.columns)
            continue;
        // Without colours, numbers that touch would read as one.
        const int margin = look.has_colors() ? 0 : 1;
        if (!is_free(taken, {row, first - margin, first + width})) continue;
        const bool is_white = is_stripe(ball.number);
        if (!look.has_colors()) {
            canvas.write(first, row, text, default_color, default_color,
                         static_cast<std::uint8_t>(is_white ? bold : bold | reverse));
            continue;
        }
        // Stripes are white, with a number in their colour, darker: the same in a light theme.
        const Color own = view.inks[*index].color;
        const Color color = is_white ? ink_of(Role::stripe_white, look).color : own;
        constexpr double legible = 0.7;
        Look dark = look;
        if (look.light_background) {
            dark.light_background = false;
            dark.ground.reset();
        }
        const Ink ink = is_white && look.has_shades() ? Ink{dimmed(own, legible, dark), bold}
                                                      : strong_text_on(color, look);
        canvas.write(first, row, text, ink.color, color, ink.attributes);
    }
}

}  // namespace carom
