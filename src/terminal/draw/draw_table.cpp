#include <algorithm>

#include "terminal/canvas/character_width.h"
#include "terminal/draw/board.h"
#include "terminal/draw/draw_parts.h"

/// The lights of a pinball table.
namespace carom {

namespace {

Ink ink_of_light(const TableLight& light, const Look& look) {
    if (!look.has_colors()) return {default_color, plain};
    return light.color ? dress_ink(*light.color, look) : ink_of_class(light.family, look);
}

void paint_lit_edge(Raster& raster, const View& view, const TableLight& light) {
    const Look& look = view.options.look;
    const RasterPoint start = to_raster(view.camera, light.shape.start);
    const double radius =
        std::max(light.shape.radius * view.camera.columns_per_length, 1.3 * raster.hairline()) +
        lit_swell(raster, look);
    const Brush brush{lit_ink(raster, ink_of_light(light, look), look), 255, '*'};
    if (light.shape.start == light.shape.end)
        paint_peg(raster, start, radius, brush);
    else
        raster.capsule(start, to_raster(view.camera, light.shape.end), radius, brush);
}

constexpr Rgb24 rubber_color = 0xb3261e;
constexpr Rgb24 bat_color = 0xf2ead6;
constexpr Rgb24 skirt_color = 0x14161c;
constexpr Rgb24 cap_color = 0xc8452f;

bool shows_parts(const Raster& raster, const View& view) {
    return raster.renderer().has_pixels() && view.options.look.has_shades();
}

// A cap on a dark skirt; a hit lights it up.
void paint_bumper(Raster& raster, const View& view, const TableLight& light) {
    if (!shows_parts(raster, view)) {
        if (light.is_lit) paint_lit_edge(raster, view, light);
        return;
    }
    const Look& look = view.options.look;
    const RasterPoint at = to_raster(view.camera, light.shape.start);
    const double radius = light.shape.radius * view.camera.columns_per_length;
    const Tones tones = tones_of(dress_ink(light.color.value_or(cap_color), look).color, look);
    constexpr std::uint8_t full = 255;
    constexpr std::uint8_t halo = 70;
    if (light.is_lit) raster.disc(at, 1.5 * radius, 0.0, {{tones.light, plain}, halo, '\0'});
    // Cells of two colours have no room for a skirt: it would leave corners around the cap.
    constexpr double least_skirt = 4.0;  // columns
    const Color cap = light.is_lit ? tones.glint : tones.base;
    if (raster.renderer().mosaic != Mosaic::halves && radius < least_skirt)
        return raster.ball(at, radius, {.tones = {cap, cap, cap, cap}});
    raster.disc(at, radius, 0.0, {dress_ink(skirt_color, look), full, '\0'});
    raster.disc(at, 0.82 * radius, 0.0, {{cap, plain}, full, '\0'});
    raster.disc({at.x - 0.2 * radius, at.y - 0.2 * radius}, 0.35 * radius, 0.0,
                {{light.is_lit ? tones.glint : tones.light, plain}, full, '\0'});
}

// A bat that is thicker at its pivot, in a ring of rubber.
void paint_flipper(Raster& raster, const View& view, const Capsule& shape) {
    if (!shows_parts(raster, view)) return;
    const Look& look = view.options.look;
    const RasterPoint pivot = to_raster(view.camera, shape.start);
    const RasterPoint tip = to_raster(view.camera, shape.end);
    const double radius = shape.radius * view.camera.columns_per_length;
    const double least = raster.hairline();
    const Ink rubber = dress_ink(rubber_color, look);
    const Ink bat = dress_ink(bat_color, look);
    constexpr std::uint8_t full = 255;
    raster.capsule(pivot, tip, std::max(radius, least), {rubber, full, '\0'});
    raster.disc(pivot, std::max(1.35 * radius, least), 0.0, {rubber, full, '\0'});
    // Where there is no room for a ring, all of it is the bat.
    constexpr double least_ring = 0.9;  // columns
    const double inner = radius < least_ring ? radius : 0.62 * radius;
    raster.capsule(pivot, tip, std::max(inner, least), {bat, full, '\0'});
    raster.disc(pivot, std::max(1.1 * inner, least), 0.0, {bat, full, '\0'});
}

void paint_gauge(Raster& raster, const View& view, const PowerGauge& gauge) {
    const Look& look = view.options.look;
    const double radius = 1.3 * raster.hairline();
    const auto at = [&](double share) {
        return to_raster(view.camera, gauge.from + (gauge.to - gauge.from) * share);
    };
    raster.capsule(at(0.0), at(1.0), radius, {ink_of(Role::faint, look), 255, '|'});
    raster.capsule(at(0.0), at(gauge.share), radius, {ink_of(Role::warning, look), 255, '#'});
}

}  // namespace

Ink lit_ink(const Raster& raster, Ink ink, const Look& look) {
    ink.attributes |= bold;
    if (!look.has_colors() && !raster.renderer().has_pixels()) ink.attributes |= reverse;
    return ink;
}

double lit_swell(const Raster& raster, const Look& look) {
    if (look.has_colors() || !raster.renderer().has_pixels()) return 0.0;
    return 1.0 / raster.renderer().across;
}

void paint_lamps(Raster& raster, const View& view) {
    if (!view.annotations.table) return;
    for (const TableLight& light : view.annotations.table->lights)
        if (!light.is_edge) paint_insert(raster, view, light);
}

void paint_lit_edges(Raster& raster, const View& view) {
    if (!view.annotations.table) return;
    for (const TableLight& light : view.annotations.table->lights)
        if (light.is_bumper)
            paint_bumper(raster, view, light);
        else if (light.is_edge && light.is_lit)
            paint_lit_edge(raster, view, light);
    for (const Capsule& flipper : view.annotations.table->flippers)
        paint_flipper(raster, view, flipper);
    for (const Capsule& plunger : view.annotations.table->plungers)
        raster.capsule(to_raster(view.camera, plunger.start), to_raster(view.camera, plunger.end),
                       plunger.radius * view.camera.columns_per_length,
                       {ink_of(Role::cue, view.options.look), 255, '#'});
    for (const PowerGauge& gauge : view.annotations.table->gauges)
        paint_gauge(raster, view, gauge);
}

void polish_balls(std::vector<Ink>& inks, const View& view, const Board& board) {
    if (!view.annotations.table || view.options.color_by != ColorBy::kind) return;
    const Look& look = view.options.look;
    Ink steel = ink_of(Role::strong, look);
    // A board may be dark in a light theme too.
    if (look.has_shades() && !board.is_empty())
        steel.color = text_color_on(
            view.memory.ground.inks().board[static_cast<std::size_t>(Ground::board)], look);
    std::ranges::fill(inks, steel);
}

}  // namespace carom
