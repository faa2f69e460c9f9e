#include "terminal/draw/overlays.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "terminal/draw/draw_parts.h"

namespace carom {

namespace {

// Grid lines closer together than this, in columns, would hide the picture.
constexpr double closest_lines = 3.0;

void paint_lattice(Raster& raster, const View& view, Vec2 origin, double spacing, const Ink& ink,
                   std::uint8_t strength) {
    if (!has_room_for_grid(view.camera, spacing)) return;
    const Box visible = visible_box(view.camera);
    const auto first = [&](double low, double from) {
        return from + std::ceil((low - from) / spacing) * spacing;
    };
    for (double x = first(visible.low.x, origin.x); x <= visible.high.x; x += spacing) {
        const double across = to_raster(view.camera, {x, 0.0}).x;
        raster.line({across, 0.0}, {across, raster.rows() * raster.aspect()}, ink, strength);
    }
    for (double y = first(visible.low.y, origin.y); y <= visible.high.y; y += spacing) {
        const double down = to_raster(view.camera, {0.0, y}).y;
        raster.line({0.0, down}, {static_cast<double>(raster.columns()), down}, ink, strength);
    }
}

// A line with an arrow head, where samples are fine enough for one.
void paint_arrow(Raster& raster, RasterPoint from, RasterPoint to, const Ink& ink) {
    raster.line(from, to, ink);
    if (raster.renderer().across == 1) return;
    const double dx = to.x - from.x;
    const double dy = to.y - from.y;
    const double length = std::sqrt(dx * dx + dy * dy);
    constexpr double head = 1.2;
    if (!(length > 2.0 * head)) return;
    const double ux = dx / length * head;
    const double uy = dy / length * head;
    raster.line({to.x - ux - 0.6 * uy, to.y - uy + 0.6 * ux}, to, ink);
    raster.line({to.x - ux + 0.6 * uy, to.y - uy - 0.6 * ux}, to, ink);
}

// The present position of a body that took part in a contact; none if the body is gone.
std::optional<Vec2> place_of_ball(const World& world, std::uint32_t ball) {
    const auto index = index_of(world, BallId{ball});
    if (!index) return std::nullopt;
    return world.balls().position[*index];
}

// A grid is drawn in faint ink. Dots without colour have no faint ink, so fewer of them are lit.
std::uint8_t lattice_strength(const Raster& raster) {
    return raster.renderer().has_dots() ? 110 : 255;
}

// Grid lines at round coordinates.
void paint_coordinates(Raster& raster, const View& view) {
    paint_lattice(raster, view, {}, round_spacing(view.camera.columns_per_length),
                  ink_of(Role::grid, view.options.look), lattice_strength(raster));
}

// The cells in which the solver looks for pairs.
void paint_broad_phase(Raster& raster, const View& view) {
    const auto& cells = view.annotations.broad_phase;
    if (!cells || !(cells->size > 0.0)) return;
    paint_lattice(raster, view, cells->origin, cells->size, ink_of(Role::grid, view.options.look),
                  lattice_strength(raster));
}

void paint_velocities(Raster& raster, const View& view) {
    if (!(view.memory.fastest > 0.0)) return;
    const Ink ink = ink_of(Role::velocity, view.options.look);
    const Balls& balls = view.world.balls();
    // In a crowd arrows are hardly longer than the balls are apart.
    const double area = raster.columns() * raster.rows() * raster.aspect();
    const double apart =
        std::sqrt(area / static_cast<double>(std::max<std::size_t>(1, balls.size())));
    const double longest = std::clamp(raster.columns() / 8.0, 4.0, std::clamp(apart, 4.0, 12.0));
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const double speed = length(balls.velocity[i]);
        const double long_by = speed / view.memory.fastest * longest;
        if (!(long_by > 0.2) || !std::isfinite(speed)) continue;
        // The arrow starts at the rim, so that the ball stays visible.
        const Vec2 way = balls.velocity[i] / speed;
        const double radius = balls.radius[i] * view.camera.columns_per_length;
        const RasterPoint center = to_raster(view.camera, balls.position[i]);
        const double far = radius + long_by;
        paint_arrow(raster, {center.x + radius * way.x, center.y - radius * way.y},
                    {center.x + far * way.x, center.y - far * way.y}, ink);
    }
}

// A line between two bodies that collided in the last tick.
void paint_contacts(Raster& raster, const View& view) {
    const Ink ink = ink_of(Role::contact, view.options.look);
    for (const Contact& contact : view.contacts) {
        const std::optional<Vec2> a = place_of_ball(view.world, contact.a);
        if (!a) continue;
        const bool is_pair = contact.kind == ContactKind::ball_ball;
        const std::optional<Vec2> b =
            is_pair ? place_of_ball(view.world, contact.b) : std::optional(contact.point);
        if (!b) continue;
        // Across a side of a torus, the line would span the whole picture.
        const auto& torus = view.world.model().wrap;
        const Vec2 apart = *b - *a;
        if (torus && (std::abs(apart.x) > 0.5 * size(*torus).x ||
                      std::abs(apart.y) > 0.5 * size(*torus).y)) {
            continue;
        }
        raster.line(to_raster(view.camera, *a), to_raster(view.camera, *b), ink);
    }
}

constexpr std::array table{
    Overlay{"velocities", "velocities", false, paint_velocities},
    Overlay{"contacts", "contacts", false, paint_contacts},
    Overlay{"broad-phase", "broad-phase cells", true, paint_broad_phase},
    Overlay{"grid", "coordinates", true, paint_coordinates},
};
static_assert(table.size() <= OverlaySet::most);

}  // namespace

double round_spacing(double columns_per_length) {
    const double wanted = 16.0 / columns_per_length;
    const double power = std::pow(10.0, std::floor(std::log10(wanted)));
    const double leading = wanted / power;
    return power * (leading < 2.0 ? 1.0 : leading < 5.0 ? 2.0 : 5.0);
}

bool has_room_for_grid(const Camera& camera, double spacing) {
    return spacing * camera.columns_per_length >= closest_lines;
}

std::span<const Overlay> overlays() {
    return table;
}

std::size_t overlay_named(std::string_view name) {
    const auto found = std::ranges::find(table, name, &Overlay::name);
    assert(found != table.end());
    return static_cast<std::size_t>(found - table.begin());
}

void paint_overlays_below(Raster& raster, const View& view) {
    for (std::size_t i = table.size(); i-- > 0;)
        if (view.options.overlays[i] && table[i].is_underneath) table[i].paint(raster, view);
}

void paint_overlays_above(Raster& raster, const View& view) {
    for (std::size_t i = 0; i < table.size(); ++i)
        if (view.options.overlays[i] && !table[i].is_underneath) table[i].paint(raster, view);
}

}  // namespace carom
