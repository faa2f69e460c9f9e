#include "terminal/panels/pool_panel.h"

#include <fmt/format.h>

#include <algorithm>

#include "terminal/canvas/character_width.h"
#include "terminal/canvas/raster.h"
#include "terminal/panels/panel.h"

namespace carom {
namespace {

constexpr int side_columns = 5;  // for the tip and the tray
constexpr int least_spare = 3;   // columns that the table leaves free; it gives up the rest
constexpr int strip_rows = 3;
constexpr int least_pool_rows = 18;   // below, the table needs them all
constexpr int least_strip_rows = 30;  // of the area, for a strip at its top

bool is_strip(const CellArea& area) {
    return area.columns > side_columns;
}

// A ball as its number on its colour, two columns wide; stripes have white numbers' ground.
int write_ball(Canvas& canvas, int column, int row, int number, const Look& look) {
    const std::string text = fmt::format("{:>2}", number);
    if (!look.has_colors())
        return canvas.write(column, row, text, default_color, default_color,
                            static_cast<std::uint8_t>(number > 8 ? bold : bold | reverse));
    const Color own = ink_of_pool_ball(number, look).color;
    const bool is_striped = number > 8;
    const Color ground = is_striped ? ink_of(Role::stripe_white, look).color : own;
    const Ink ink = is_striped ? Ink{own, bold} : strong_text_on(own, look);
    return canvas.write(column, row, text, ink.color, ground, ink.attributes);
}

// From the middle of the ball to its rim, the tip moves further than to scale: so it shows.
constexpr double tip_scale = 1.4;

// White on a white page would not be seen.
Ink ball_ink(const Look& look) {
    return look.light_background ? ink_of(Role::faint, look) : ink_of_pool_ball(0, look);
}

// In characters, three rows of five.
void write_tip(Canvas& canvas, const CellArea& area, const PoolPanel::Tip& tip, const Look& look) {
    const Color white = ball_ink(look).color;
    const int column = area.column + (area.columns - 5) / 2;
    int row = area.row;
    for (const std::string_view text : {" .-. ", "(   )", " '-' "})
        canvas.write(column, row++, text, white);
    constexpr double half_way = 0.5;  // of the furthest place, half a radius
    const auto steps = [](double offset) {
        return std::clamp(std::lround(offset / half_way), -1L, 1L);
    };
    const Ink ink = ink_of(Role::contact, look);
    canvas.write(column + 2 + static_cast<int>(steps(tip.side)),
                 area.row + 1 - static_cast<int>(steps(tip.follow)), "x", ink.color, default_color,
                 bold);
}

// The cue ball as the player sees it, and the point that the tip strikes.
void draw_tip(Canvas& canvas, const CellArea& area, const PoolPanel::Tip& tip,
              const Renderer& renderer, double aspect, const Look& look) {
    if (renderer.has_regions()) return write_tip(canvas, area, tip, look);
    Raster raster(renderer, area.columns, area.rows, aspect, look);
    // The middle is the middle of a pixel, so that the tip in the middle is seen to be there.
    const double width = 1.0 / renderer.across;
    const double height = aspect / renderer.down;
    const auto middle_of = [](int pixels, double size) { return ((pixels - 1) / 2 + 0.5) * size; };
    const RasterPoint middle{middle_of(raster.samples_across(), width),
                             middle_of(raster.samples_down(), height)};
    const double radius = std::min(middle.x, middle.y);
    const Ink white = ball_ink(look);
    const RasterPoint at{middle.x + tip_scale * radius * tip.side,
                         middle.y - tip_scale * radius * tip.follow};
    if (renderer.has_pixels()) {
        raster.disc(middle, radius, 0.0, {.ink = white, .is_crisp = true});
        raster.disc(at, 0.2 * radius, 0.0, {.ink = ink_of(Role::contact, look), .is_crisp = true});
    } else {
        raster.disc(middle, radius, 2.0 * raster.hairline(), {white, 0, ' '});
        raster.disc(at, 0.0, 0.0, {ink_of(Role::contact, look), 255, '\0'});
    }
    raster.show(canvas, area.column, area.row);
}

enum class Side { left, right };  // of the score

// The rows of a player: its name, then its group and the balls that it has left. Both lie beside
// the score.
void draw_player(Canvas& canvas, const CellArea& area, const PoolPanel::Player& player, Side side,
                 const Look& look) {
    const auto start = [&](int width) {
        return side == Side::right ? area.column : area.column + std::max(0, area.columns - width);
    };
    const std::string_view mark = player.is_turn ? (look.utf8 ? "▸ " : "> ") : "  ";
    const std::string name = std::string(mark) + player.name;
    const int first = start(columns_of(name));
    write_cut(canvas, {first, area.row, area.columns, area.rows}, 0, name,
              ink_of(player.is_turn ? Role::strong : Role::text, look));
    if (player.group.empty()) return;
    const int balls = 3 * static_cast<int>(player.left.size());
    const std::string group = "  " + player.group;
    int column = start(columns_of(group) + balls);
    const int end = area.column + area.columns;
    write_cut(canvas, {column, area.row, end - column, area.rows}, 1, group,
              ink_of(Role::faint, look));
    column += columns_of(group) + 1;
    for (const int ball : player.left) {
        if (column + 2 > end) return;
        column = write_ball(canvas, column, area.row + 1, ball, look) + 1;
    }
}

// Over the middle of the table, as far as the area has room.
void draw_tray(Canvas& canvas, const CellArea& area, int table_columns, const PoolPanel& panel,
               const Look& look) {
    if (panel.tray.empty()) return;
    const int row = area.rows - 1;
    const std::string_view title = "pocketed ";
    const int width = columns_of(title) + 3 * static_cast<int>(panel.tray.size());
    const int middle = (table_columns - 2 - width) / 2;
    int column = area.column + std::clamp(middle, 0, std::max(0, area.columns - width));
    column = canvas.write(column, area.row + row, title, ink_of(Role::faint, look).color);
    for (const int ball : panel.tray) {
        if (column + 2 > area.column + area.columns) return;
        column = write_ball(canvas, column, area.row + row, ball, look) + 1;
    }
}

void draw_strip(Canvas& canvas, const CellArea& area, const PoolPanel& panel,
                const Renderer& renderer, double aspect, const Look& look) {
    const int tip_columns = 2 * area.rows;
    const int columns = area.columns - 2 - (panel.tip ? tip_columns + 2 : 0);
    if (panel.players) {
        const auto& [first, second] = *panel.players;
        std::string score = fmt::format("{} : {}", first.frames, second.frames);
        if (panel.race > 0) score += fmt::format("   race to {}", panel.race);
        // The score is over the middle of the table.
        const int middle = columns_of(score) + 4;
        const int side = (area.columns - 2 - middle) / 2;
        draw_player(canvas, {area.column + 1, area.row, side, area.rows}, first, Side::left, look);
        draw_player(canvas,
                    {area.column + 1 + side + middle, area.row,
                     std::min(side, columns - side - middle), area.rows},
                    second, Side::right, look);
        canvas.write(area.column + 3 + side, area.row, score, ink_of(Role::counter, look).color,
                     default_color, bold);
    }
    draw_tray(canvas, {area.column + 1, area.row, columns, area.rows}, area.columns, panel, look);
    if (panel.tip)
        draw_tip(canvas,
                 {area.column + area.columns - tip_columns - 1, area.row, tip_columns, area.rows},
                 *panel.tip, renderer, aspect, look);
}

void draw_column(Canvas& canvas, const CellArea& area, const PoolPanel& panel,
                 const Renderer& renderer, double aspect, const Look& look) {
    constexpr int tip_rows = 3;
    int row = area.row;
    if (panel.tip)
        draw_tip(canvas, {area.column, row, area.columns, tip_rows}, *panel.tip, renderer, aspect,
                 look);
    row += tip_rows + 1;
    for (const int ball : panel.tray) {
        if (row >= area.row + area.rows) return;
        write_ball(canvas, area.column + 1, row++, ball, look);
    }
}

}  // namespace

CellArea cut_pool_panel(CellArea& area, double table_shape, double aspect) {
    if (area.rows < least_pool_rows) return {};
    const bool leaves_rows = area.columns < table_shape * area.rows * aspect;
    if (leaves_rows && area.rows >= least_strip_rows) {
        const CellArea strip{area.column, area.row, area.columns, strip_rows};
        area.row += strip_rows;
        area.rows -= strip_rows;
        return strip;
    }
    const int spare = area.columns - static_cast<int>(table_shape * area.rows * aspect);
    if (leaves_rows || spare < least_spare) return {};
    area.columns -= side_columns;
    return {area.column + area.columns, area.row, side_columns, area.rows};
}

void draw_pool_panel(Canvas& canvas, const CellArea& area, const PoolPanel& panel,
                     const Renderer& renderer, double aspect, const Look& look) {
    if (area.columns <= 0 || area.rows <= 0) return;
    canvas.clear(area);
    if (is_strip(area))
        draw_strip(canvas, area, panel, renderer, aspect, look);
    else
        draw_column(canvas, area, panel, renderer, aspect, look);
}

}  // namespace carom
