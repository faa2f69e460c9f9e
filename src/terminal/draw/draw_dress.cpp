#include <algorithm>
#include <cmath>

#include "terminal/canvas/character_width.h"
#include "terminal/draw/board_texts.h"
#include "terminal/draw/draw_parts.h"

/// Draws the dress of a level: the colours of its balls and edges, and its labels.
namespace carom {

void dress_balls(std::vector<Ink>& inks, const Scene& scene, const World& world, const Look& look) {
    const Dress& dress = scene.dress;
    if (!look.has_colors() || (dress.balls.empty() && dress.kinds.empty())) return;
    const Balls& balls = world.balls();
    for (std::size_t i = 0; i < inks.size(); ++i) {
        auto color = color_in(dress.balls, number(balls.id[i]));
        if (!color) color = color_in(dress.kinds, balls.kind[i]);
        if (color) inks[i] = dress_ink(*color, look);
    }
}

Ink edge_ink(const View& view, std::size_t edge) {
    const Look& look = view.options.look;
    const Capsules& edges = view.world.capsules();
    const Dress& dress = view.scene.dress;
    auto color = color_in(dress.edges, number(edges.id[edge]));
    if (!color) color = color_in(dress.materials, edges.material[edge]);
    if (!color) color = dress.theme.edge;
    if (!color && is_pool_table(view.scene) && look.has_shades())
        return {view.memory.ground.inks().nose, plain};
    if (color && look.has_colors()) return dress_ink(*color, look);
    return ink_of_material(edges.material[edge], look);
}

namespace {

struct HungBall {
    RasterPoint pivot;
    RasterPoint middle;
    double radius = 0.0;
    double bar = 0.0;  // half the thickness of the bar
    Ink ball_ink;
    Ink bar_ink;
    Ink string_ink;
};

// A cell of a mosaic shows two colours. So the string has the colour of the bar in the bar's cells,
// and that of the ball in the ball's: a third one would take the place of their borders.
void paint_string_in_cells(Raster& raster, const HungBall& hung, std::uint8_t strength) {
    const double across = hung.middle.x - hung.pivot.x;
    const double down = hung.middle.y - hung.pivot.y;
    const bool is_upright = std::abs(down) >= std::abs(across);
    const double size = is_upright ? raster.aspect() : 1.0;
    const double from = (is_upright ? hung.pivot.y : hung.pivot.x) / size;
    const double way = (is_upright ? down : across) / size;  // in cells
    const double sign = way < 0.0 ? -1.0 : 1.0;
    const auto border_before = [&](double at) { return sign * std::floor(sign * at); };
    const auto border_after = [&](double at) { return sign * std::ceil(sign * at); };
    constexpr double pixel_before = 1e-6;
    const double below_bar = border_after(from + sign * hung.bar / size);
    const double above_ball = border_before(from + way - sign * hung.radius / size);
    const auto piece = [&](double start, double end, const Ink& ink, std::uint8_t tone) {
        const auto at = [&](double place) {
            const double share = std::clamp((place - from) / way, 0.0, 1.0);
            return RasterPoint{hung.pivot.x + share * across, hung.pivot.y + share * down};
        };
        if (sign * (end - start) > 0.0)
            raster.line(at(start), at(end - sign * pixel_before), ink, tone);
    };
    constexpr std::uint8_t full = 255;
    piece(from, below_bar, hung.bar_ink, full);
    piece(below_bar, above_ball, hung.string_ink, strength);
    piece(above_ball, from + way, hung.ball_ink, full);
}

}  // namespace

void paint_cradles(Raster& raster, const View& view) {
    const Look& look = view.options.look;
    const std::vector<CradleString>& strings = view.scene.dress.strings;
    if (strings.empty() || !view.annotations.copies.empty()) return;
    constexpr Rgb24 bar_color = 0x7a4a24;
    const std::uint8_t thin = raster.renderer().has_pixels() ? 110 : 255;
    const Ink bar = look.has_colors() ? dress_ink(bar_color, look) : ink_of(Role::edge, look);
    const Ink line = ink_of(Role::faint, look);
    constexpr double bar_share = 0.25;  // half its thickness, of the radius of a ball
    const double per_length = view.camera.columns_per_length;
    const auto at = [&](Vec2 place) { return to_raster(view.camera, place); };
    for (std::size_t first = 0; first < strings.size();) {
        std::size_t last = first;
        while (last + 1 < strings.size() && !strings[last + 1].is_first)
            ++last;
        const Vec2 span = strings[last].pivot - strings[first].pivot;
        const Vec2 along = length(span) > 0.0 ? span / length(span) : Vec2{1.0, 0.0};
        double radius = 0.0;
        double swing = 0.0;  // how far the balls that move at the start were pulled aside
        for (std::size_t i = first; i <= last; ++i) {
            const auto ball = index_of(view.world, BallId{strings[i].ball});
            if (!ball) continue;
            radius = std::max(radius, view.world.balls().radius[*ball]);
            const Vec2 place = view.world.balls().position[*ball];
            const double moved = dot(place - strings[i].pivot, along);
            const RasterPoint pivot = at(strings[i].pivot + along * moved);
            const double columns = view.world.balls().radius[*ball] * per_length;
            if (raster.renderer().is_sharp && look.has_colors())
                paint_string_in_cells(
                    raster,
                    {pivot, at(place), columns, bar_share * columns, view.inks[*ball], bar, line},
                    thin);
            else
                raster.line(pivot, at(place), line, thin);
            const World& start = view.scene.world;
            if (const auto began = index_of(start, BallId{strings[i].ball}))
                swing = std::max(
                    swing, std::abs(dot(start.balls().position[*began] - strings[i].pivot, along)));
        }
        // The bar reaches as far as the walls that send the balls back: twice the swing.
        const double reach = std::max(2.0 * swing, 2.0 * radius);
        raster.capsule(at(strings[first].pivot - along * reach),
                       at(strings[last].pivot + along * reach), bar_share * radius * per_length,
                       {bar, 255, '='});
        first = last + 1;
    }
}

void write_board_labels(BoardTexts& texts, const View& view) {
    const Look& look = view.options.look;
    const CellArea& area = view.camera.area;
    for (const BoardLabel& label : view.scene.dress.labels) {
        const CellPoint at = to_cells(view.camera, label.at);
        const bool is_near =
            at.row >= area.row && at.row < area.row + area.rows && std::abs(at.column) < 1e6;
        if (!is_near) continue;
        const double share = label.align == BoardLabel::Align::left    ? 0.0
                             : label.align == BoardLabel::Align::right ? 1.0
                                                                       : 0.5;
        const Ink ink = label.color ? dress_ink(*label.color, look) : ink_of(Role::text, look);
        const auto first = std::lround(at.column - share * columns_of(label.text));
        texts.write(static_cast<int>(first), static_cast<int>(at.row), label.text, ink);
    }
}

}  // namespace carom
