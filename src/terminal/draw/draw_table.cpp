#include <algorithm>

#include "terminal/draw/draw_parts.h"

/// The lights of a pinball table.
namespace carom {

namespace {

Ink ink_of_light(const TableLight& light, const Look& look) {
    if (!look.has_colors()) return {default_color, light.is_lit ? bold : dim};
    Ink ink = ink_of_class(light.family, look);
    if (light.is_lit)
        ink.attributes |= bold;
    else if (look.colors >= 256)
        ink.color = dimmed(ink.color, 0.45, look);
    else
        ink = ink_of(Role::faint, look);
    return ink;
}

void paint_lamp(Raster& raster, const View& view, const TableLight& light) {
    const Look& look = view.options.look;
    const Ink ink = ink_of_light(light, look);
    const RasterPoint at = to_raster(view.camera, light.shape.start);
    const double radius =
        std::max(light.shape.radius * view.camera.columns_per_length, 1.2 * raster.hairline());
    if (raster.renderer().has_regions()) {
        raster.stamp(at, light.is_lit ? "*" : ".", ink);
    } else if (light.is_lit) {
        raster.disc(at, radius, 0.0, {ink, 255, '*'});
    } else if (raster.renderer().has_pixels()) {
        raster.disc(at, radius, 0.0, {ink, 255, '.'});
    } else {
        raster.disc(at, 0.0, 0.0, {ink, 255, '.'});
    }
}

void paint_lit_edge(Raster& raster, const View& view, const TableLight& light) {
    const RasterPoint start = to_raster(view.camera, light.shape.start);
    const double radius =
        std::max(light.shape.radius * view.camera.columns_per_length, 1.3 * raster.hairline());
    const Brush brush{ink_of_light(light, view.options.look), 255, '*'};
    if (light.shape.start == light.shape.end)
        raster.disc(start, radius, 0.0, brush);
    else
        raster.capsule(start, to_raster(view.camera, light.shape.end), radius, brush);
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

void paint_lamps(Raster& raster, const View& view) {
    if (!view.annotations.table) return;
    for (const TableLight& light : view.annotations.table->lights)
        if (!light.is_edge) paint_lamp(raster, view, light);
}

void paint_lit_edges(Raster& raster, const View& view) {
    if (!view.annotations.table) return;
    for (const TableLight& light : view.annotations.table->lights)
        if (light.is_edge && light.is_lit) paint_lit_edge(raster, view, light);
    for (const Capsule& plunger : view.annotations.table->plungers)
        raster.capsule(to_raster(view.camera, plunger.start), to_raster(view.camera, plunger.end),
                       plunger.radius * view.camera.columns_per_length,
                       {ink_of(Role::cue, view.options.look), 255, '#'});
    for (const PowerGauge& gauge : view.annotations.table->gauges)
        paint_gauge(raster, view, gauge);
}

void polish_balls(std::vector<Ink>& inks, const View& view) {
    if (!view.annotations.table || view.options.color_by != ColorBy::kind) return;
    std::ranges::fill(inks, ink_of(Role::strong, view.options.look));
}

}  // namespace carom
