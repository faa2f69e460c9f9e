#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "terminal/canvas/character_width.h"
#include "terminal/draw/draw_parts.h"

/// Draws what balls do to the picture around them: shadows on cloth, flashes where they collide,
/// and the scale of their colours.
namespace carom {

namespace {

constexpr double flash_time = 0.12;   // s
constexpr double white_share = 0.25;  // of the time; then it glows
constexpr double most_flash_columns = 4.0;
constexpr std::size_t most_flashes = 24;
// The share of the fastest ball's speed from which an impact flashes.
constexpr double least_approach = 0.25;
// More balls than this collide all the time, all over the picture.
constexpr std::size_t most_flashing_balls = 250;

double age_of(const ImpactFlash& flash, const World& world) {
    return static_cast<double>(world.tick() - flash.tick) / world.rate();
}

}  // namespace

void note_impacts(ViewMemory& memory, const World& world, std::span<const Contact> contacts) {
    std::erase_if(memory.flashes, [&](const ImpactFlash& flash) {
        return flash.tick > world.tick() || age_of(flash, world) >= flash_time;
    });
    if (memory.flashed_at == world.tick() || world.balls().size() > most_flashing_balls) return;
    memory.flashed_at = world.tick();
    for (const Contact& contact : contacts) {
        if (memory.flashes.size() >= most_flashes) break;
        if (!(contact.approach >= least_approach * memory.fastest) || !(contact.approach > 0.0))
            continue;
        const auto ball = index_of(world, BallId{contact.a});
        if (!ball) continue;
        double radius = world.balls().radius[*ball];
        // Of two balls the smaller: a large one flashes no more than what it hits.
        if (contact.kind == ContactKind::ball_ball)
            if (const auto other = index_of(world, BallId{contact.b}))
                radius = std::min(radius, world.balls().radius[*other]);
        memory.flashes.push_back({contact.point, radius, world.tick()});
    }
}

void paint_flashes(Raster& raster, const View& view) {
    const Look& look = view.options.look;
    if (!raster.renderer().has_pixels() || !look.has_shades()) return;
    const Ink white = ink_of(Role::stripe_white, look);
    const Ink ember = ink_of(Role::warning, look);
    for (const ImpactFlash& flash : view.memory.flashes) {
        const double age = age_of(flash, view.world) / flash_time;
        const double largest =
            std::min(flash.radius * view.camera.columns_per_length, most_flash_columns);
        // White fading on black is grey, and looks like a stone: what fades glows.
        const Ink ink = age < white_share ? white : ember;
        const auto tone = static_cast<std::uint8_t>(230.0 * (1.0 - age) * (1.0 - age));
        if (tone == 0) continue;  // a brush of tone 0 clears what it paints
        raster.disc(to_raster(view.camera, flash.place), largest * (0.35 + 0.5 * age), 0.0,
                    {ink, tone, '\0'});
    }
}

void paint_shadows(Raster& raster, const View& view) {
    const Look& look = view.options.look;
    if (!view.annotations.pool || !raster.renderer().has_pixels() || !look.has_shades()) return;
    const Balls& balls = view.world.balls();
    const Color black = dress_ink(0, look).color;
    for (std::size_t i = 0; i < balls.size(); ++i)
        raster.ball_shadow(to_raster(view.camera, balls.position[i]),
                           balls.radius[i] * view.camera.columns_per_length,
                           {.number_width = number_width(view, i)}, black);
}

void write_scale(Canvas& canvas, const View& view) {
    const Look& look = view.options.look;
    const CellArea& area = view.camera.area;
    const bool is_speed = view.options.color_by == ColorBy::speed;
    if (!is_speed && view.options.color_by != ColorBy::mass) return;
    if (!look.has_colors() || view.world.balls().size() == 0) return;
    const std::string low = is_speed ? "0" : "light";
    const std::string high = is_speed ? fmt::format("{:.3g}/s", view.memory.fastest) : "heavy";
    constexpr int steps = 10;
    const int width = columns_of(low) + columns_of(high) + steps + 4;
    if (area.columns < 2 * width || area.rows < 8) return;
    const Ink text = ink_of(Role::text, look);
    int column = area.column + area.columns - width;
    column = canvas.write(column, area.row, " " + low + " ", text.color, default_color, plain);
    for (int i = 0; i < steps; ++i) {
        const Ink ink = ink_of_scale((i + 0.5) / steps, look);
        canvas.put(column++, area.row,
                   {look.utf8 ? U'█' : U'=', ink.color, default_color, ink.attributes});
    }
    canvas.write(column, area.row, " " + high + " ", text.color, default_color, plain);
}

}  // namespace carom
